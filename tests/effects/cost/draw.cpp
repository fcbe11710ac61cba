// Draws frames of the drawing whose number it is given, by the pipeline that it is linked with, and prints
// "arena instructions": bytes, with those of what is posed, and instructions of a frame without posing it, where this
// target counts them. Exit status 1: it could not be drawn.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "cortex_m/console.hpp"
#include "counter.hpp"
#include "list.hpp"
#include "pipeline.hpp"
#include "zstrip_scenes/stage.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::effects_cost;

constexpr std::uint32_t kDrawings = 2 * std::size(kCosts);
template <class Bytes>
constexpr std::size_t most(Bytes bytes) {
  std::size_t result = 0;
  for (std::size_t i = 0; i < kDrawings; ++i) result = std::max<std::size_t>(result, bytes(drawing_at(i)));
  return result;
}
alignas(kArenaAlignment) std::array<std::byte, most([](const Drawing& each) { return each.plan.bytes(); })> arena;
alignas(
    4) std::array<std::byte, most([](const Drawing& each) { return each.plan.strip_pixel_bytes(each.view); })> pixels;
scenes::Staged staged;

}  // namespace

int main() {
  const std::uint32_t number = chosen_drawing();
  if (number >= kDrawings || !start_counter()) return 1;
  const Drawing& drawing = drawing_at(number);
  Counter counter;
  for (std::uint32_t repeat = 0; repeat < repeats(); ++repeat) {
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
      stage(*drawing.scene, staged, frame, kFramesPerTurn, drawing.view);
      if (drawing.scene->pose != nullptr && !drawing.scene->pose(frame)) return 1;
      counter.resume();
      Status status = cost_begin_frame(staged.scene, staged.camera, drawing.view, drawing.plan,
                                       std::span(arena).first(drawing.plan.bytes()));
      for (std::uint16_t strip = 0; status && strip < drawing.plan.strips; ++strip)
        status = cost_draw_strip(strip, pixels);
      counter.pause();
      if (!status) return 1;
    }
  }
  board::print_decimal(drawing.plan.bytes() + drawing.scene->pose_bytes);
  board::print(" ");
  board::print_decimal(counter.instructions() / kFrames);
  board::print("\n");
  return 0;
}
