// A program for small boards: draws some frames of a scene on the turntable, strip by strip within a given number of
// bytes, and reports on the console: one line of JSON with the plan, each frame's checksum and the deepest stack.
#pragma once

#include <cstdint>

#include "cortex_m/console.hpp"
#include "cortex_m/stack.hpp"
#include "portable/checksum_panel.hpp"
#include "portable/scene_player.hpp"
#include "portable/turntable_motion.hpp"

namespace zstrip::board {

inline void print_member(const char* name, std::uint32_t value) {
  print(", \"");
  print(name);
  print("\": ");
  print_decimal(value);
}

/// Draws frames 0 to frames - 1 of a rotation in `frames_per_turn` frames, with a preset: `scene` in width x height
/// pixels in the format of SPI panels, with `bytes` of memory for arena and pixels. main returns the result.
template <const scenes::BuiltIn& scene, std::uint16_t width, std::uint16_t height, std::uint32_t bytes,
          const Quality& preset = quality::balanced>
struct Turntable {
  static constexpr std::uint32_t kFrames = 4;
  static constexpr std::uint32_t kFramesPerTurn = 12;
  static constexpr View kView{width, height, PixelFormat::rgb565_swapped};
  // These boards poll the panel's bus: a second strip of pixels would save no time.
  static constexpr Budget kBudget{.bytes = bytes, .split_columns = true, .strip_buffers = 1};
  using Player = ScenePlayer<TurntableMotion<scene, kView, kBudget, kFramesPerTurn, preset>>;

  static int run() {
    print("{\"scene\": \"");
    print(scene.name);
    print("\"");
    print_plan();
    print(", \"frames\": [");
    ChecksumPanel<width, height> panel;
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
      if (const Failure failure = Player::show(panel, frame)) {
        print("\nturntable: ");
        print(failure);
        return 1;
      }
      print(frame == 0 ? "\"" : ", \"");
      print_hex(panel.crc32());
      print("\"");
    }
    print("]");
    print_member("stack_bytes", stack_bytes_used());
    print("}\n");
    return 0;
  }

  static void print_plan() {
    constexpr Plan kPlan = Player::kPlan;
    print_member("width", width);
    print_member("height", height);
    print_member("frames_per_turn", kFramesPerTurn);
    print_member("strip_rows", kPlan.strip_rows);
    print_member("strip_columns", kPlan.strip_columns);
    print_member("strips", kPlan.strips);
    print_member("arena_bytes", kPlan.bytes());
    print_member("strip_pixel_bytes", kPlan.strip_pixel_bytes(kView));
  }
};

}  // namespace zstrip::board
