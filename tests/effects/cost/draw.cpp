// Draws frames of COST_SCENE by the one pipeline that it calls for and prints "arena instructions": bytes, and those of
// a frame, where this target counts them. Exit status 1: it could not be drawn.
#include <array>
#include <cstddef>
#include <cstdint>

#include "cortex_m/console.hpp"
#include "counter.hpp"
#include "plain.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_scenes/stage.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::effects_cost;

constexpr const scenes::BuiltIn& kBuiltIn = kChosen<scenes::COST_SCENE, COST_PLAIN>;
constexpr View kPicture = kView<scenes::COST_SCENE, COST_PLAIN>;
constexpr Effects kEffects = kEffectsOf<scenes::COST_SCENE, COST_PLAIN>;
constexpr Plan kPlan = plan(kBuiltIn.counts, kPicture, kEffects, {.strip_rows = kPicture.height}).plan;
alignas(kArenaAlignment) std::array<std::byte, kPlan.bytes()> arena;
alignas(4) std::array<std::byte, kPlan.strip_pixel_bytes(kPicture)> pixels;
Renderer<kEffects> renderer;
scenes::Staged staged;

}  // namespace

int main() {
  if (!start_counter()) return 1;
  Counter counter;
  for (std::uint32_t repeat = 0; repeat < repeats(); ++repeat) {
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
      stage(kBuiltIn, staged, frame, kFramesPerTurn, kPicture);
      counter.resume();
      Status status = renderer.begin_frame(staged.scene, staged.camera, kPicture, kPlan, arena);
      for (std::uint16_t strip = 0; status && strip < kPlan.strips; ++strip)
        status = renderer.draw_strip(strip, pixels);
      counter.pause();
      if (!status) return 1;
    }
  }
  board::print_decimal(kPlan.bytes());
  board::print(" ");
  board::print_decimal(counter.instructions() / kFrames);
  board::print("\n");
  return 0;
}
