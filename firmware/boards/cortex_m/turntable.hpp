// A program for small boards: some frames of a scene on the turntable, drawn strip by strip within a given number of
// bytes, and a report on the console: one line of JSON with the plan, each frame's checksum and the deepest stack.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cortex_m/console.hpp"
#include "cortex_m/stack.hpp"
#include "portable/checksum_panel.hpp"
#include "zstrip/frame/renderer.hpp"
#include "zstrip_hal/present.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::board {

inline void print_member(const char* name, std::uint32_t value) {
  print(", \"");
  print(name);
  print("\": ");
  print_decimal(value);
}

inline int report_failure(const char* doing, const char* error) {
  print("\nturntable: ");
  print(doing);
  print(": ");
  print(error);
  print("\n");
  return 1;
}

/// `scene` in a picture of width x height pixels, as panels on SPI take them, in `bytes` of memory for arena and
/// pixels: frames 0 to frames - 1 of a turn in `frames_per_turn`. The result is main's.
template <const scenes::BuiltIn& scene, std::uint16_t width, std::uint16_t height, std::uint32_t bytes>
struct Turntable {
  static constexpr std::uint32_t kFrames = 4;
  static constexpr std::uint32_t kFramesPerTurn = 12;
  static constexpr View kView{width, height, PixelFormat::rgb565_swapped};
  static constexpr Effects kEffects = effects_of(scene.scene, scene.camera);
  static constexpr PlanResult kPlanned =
      plan(scene.counts, kView, kEffects, {.bytes = bytes, .split_columns = true, .strip_buffers = 1});
  static_assert(kPlanned.status, "the scene does not fit");
  static constexpr Plan kPlan = kPlanned.plan;

  // The bus of a panel is polled on boards like these: a second strip of pixels would not save any time.
  alignas(kArenaAlignment) static inline constinit std::array<std::byte, kPlan.bytes()> arena{};
  alignas(4) static inline constinit std::array<std::byte, kPlan.strip_pixel_bytes(kView)> pixels{};
  static inline constinit Renderer<kEffects> renderer{};
  static inline constinit scenes::Staged staged{};

  static int run() {
    print("{\"scene\": \"");
    print(scene.name);
    print("\"");
    print_plan();
    print(", \"frames\": [");
    ChecksumPanel<width, height> panel;
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
      stage(scene, staged, frame, kFramesPerTurn, kView);
      if (const Status begun = renderer.begin_frame(staged.scene, staged.camera, kView, kPlan, arena); !begun) {
        return report_failure("begin of the frame", message(begun.error));
      }
      const auto shown =
          hal::present(renderer, panel, {kPlan.strips, kPlan.strip_rows, kPlan.strip_columns}, {pixels, {}});
      if (!shown.draw) return report_failure("drawing", message(shown.draw.error));
      if (shown.display != hal::Error::none) return report_failure("display", hal::message(shown.display));
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
