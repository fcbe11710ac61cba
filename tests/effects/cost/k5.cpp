// Firmware of workload K5 whose one pipeline has the effects COST_EFFECTS and the methods COST_METHODS. Prints
// "crc32 arena instructions": of the pixels of all frames; bytes; of a frame. Exit status 1: it could not be drawn.
#include "k5.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "cortex_m/console.hpp"
#include "counter.hpp"
#include "portable/crc32.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::effects_cost {

inline constexpr View kPicture{160, 120, PixelFormat::rgb565};
/// Of the renderer that takes samples: not a constant, or the compiler would leave out what more than one sample takes.
inline View picture_of_samples = kPicture;

}  // namespace zstrip::effects_cost

namespace {

using namespace zstrip;
using namespace zstrip::effects_cost;

constexpr std::uint32_t kFrames = 4, kFramesPerTurn = 36;
constexpr Effects kEffects{COST_EFFECTS, COST_METHODS};
constexpr const scenes::BuiltIn& kBuiltIn = Drawable<kEffects>::kBuiltIn;
constexpr const View& kView = kEffects.has(effect::supersampled) ? picture_of_samples : kPicture;
constexpr PlanResult kPlanned =
    plan(kBuiltIn.counts, kPicture, kEffects, {.strip_rows = kPicture.height, .modes = Modes::streamed});
static_assert(kPlanned.status);
constexpr Plan kPlan = kPlanned.plan;
alignas(kArenaAlignment) std::array<std::byte, kPlan.bytes()> arena;
alignas(4) std::array<std::byte, kPlan.strip_pixel_bytes(kPicture)> pixels;
Renderer<kEffects> renderer;
scenes::Staged staged;

}  // namespace

int main() {
  if (!start_counter()) return 1;
  Counter counter;
  board::Crc32 crc;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    stage(kBuiltIn, staged, frame, kFramesPerTurn, kView);
    counter.resume();
    Status status = renderer.begin_frame(staged.scene, staged.camera, kView, kPlan, arena);
    if (status) status = renderer.draw_strip(0, pixels);
    counter.pause();
    if (!status) return 1;
    crc.add(pixels);
  }
  board::print_hex(crc.value());
  board::print(" ");
  board::print_decimal(kPlan.bytes());
  board::print(" ");
  board::print_decimal(counter.instructions() / kFrames);
  board::print("\n");
  return 0;
}
