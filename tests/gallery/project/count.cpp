// Draws frames of a baked scene, evenly spread over its motion, and prints "rows crc32 instructions...": the rows of a
// strip, the checksum of all pixels, and what each frame takes. Bending skins is counted (GALLERY_BENDS); posing
// instances is not, nor is the checksum.
// Exit status 1: it could not be drawn.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "cortex_m/console.hpp"
#include "mps2/instruction_counter.hpp"
#include "portable/crc32.hpp"
#include "scene.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace {

using namespace zstrip;

constexpr std::uint32_t kFrames = 4;  // 0, 1/4, 1/2 and 3/4 of the motion
constexpr scenes::AtRest kAtRest{baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn};
alignas(kArenaAlignment) std::array<std::byte, baked::kPlan.bytes()> arena;
alignas(4) std::array<std::byte, baked::kPlan.strip_pixel_bytes(baked::kView)> pixels;
std::array<Instance, baked::kScene.instances.size()> instances;
Renderer<baked::kEffects> renderer;

/// Moves the vertices of skins to their place in a frame.
Status bend([[maybe_unused]] std::uint32_t frame) {
#ifdef GALLERY_BENDS
  return baked::pose_skins(baked::kJointAnimation.duration / kFrames * frame);
#else
  return {};
#endif
}

/// Adds the pixels to `crc`.
Status draw(const scenes::BakedFrame& frame, board::InstructionCounter& counter, board::Crc32& crc) {
  counter.resume();
  Status status = renderer.begin_frame(frame.scene, frame.camera, baked::kView, baked::kPlan, arena);
  counter.pause();
  for (std::uint16_t strip = 0; status && strip < baked::kPlan.strips; ++strip) {
    counter.resume();
    status = renderer.draw_strip(strip, pixels);
    counter.pause();
    const Rect area = baked::kPlan.strip_area(strip, baked::kView);
    crc.add(std::span(pixels).first(static_cast<std::uint32_t>(area.height()) *
                                    bytes_per_row(baked::kView.width, baked::kView.format)));
  }
  return status;
}

}  // namespace

int main() {
  if (!board::start_instruction_counter()) return 1;
  board::Crc32 crc;
  std::array<std::uint64_t, kFrames> counted;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    board::InstructionCounter counter;
    counter.resume();
    const Status bent = bend(frame);
    counter.pause();
    if (!bent || !draw(scenes::stage(kAtRest, frame, kFrames, {instances}), counter, crc)) return 1;
    counted[frame] = counter.instructions();
  }
  board::print_decimal(baked::kPlan.strip_rows);
  board::print(" ");
  board::print_hex(crc.value());
  for (const std::uint64_t instructions : counted) {
    board::print(" ");
    board::print_decimal(instructions);
  }
  board::print("\n");
  return 0;
}
