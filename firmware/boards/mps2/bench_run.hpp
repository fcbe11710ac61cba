// The common part of the benchmark programs: a program lists its workloads and calls run_bench. It runs frames of the
// workload that the command line selects, and prints one line of JSON with the instructions of each frame and a
// checksum of its pixels. Instructions are counted for posing the moving data in RAM, the begin of the frame, clearing,
// drawing and resolving; not for preparing the scene, the checksum and printing. Exit status: 0 done, 2 wrong words, 5
// too little memory, 1 any other error.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "cortex_m/board.hpp"
#include "cortex_m/console.hpp"
#include "cortex_m/semihosting.hpp"
#include "cortex_m/stack.hpp"
#include "mps2/arguments.hpp"
#include "mps2/instruction_counter.hpp"
#include "portable/crc32.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::bench {

using board::InstructionCounter;
using board::print;
using board::print_decimal;
using board::print_hex;

enum ExitStatus : int { kDone = 0, kFailed = 1, kUsage = 2, kBudget = 5 };

/// Holds the arena, followed by the pixels of one strip.
alignas(zstrip::kArenaAlignment) inline std::byte memory[4'000'000];

inline void print(std::string_view text) {
  for (const char character : text) zstrip::board::put_character(character);
}

inline void print_member(const char* name, std::uint64_t value) {
  print(", \"");
  print(name);
  print("\": ");
  print_decimal(value);
}

inline int report(const zstrip::Status& status) {
  print("bench: ");
  print(zstrip::message(status.error));
  print(", needed ");
  print_decimal(status.needed);
  print(", available ");
  print_decimal(status.available);
  print("\n");
  return status.error == zstrip::Error::arena_too_small ? kBudget : kFailed;
}

struct FrameResult {
  zstrip::Status status;
  std::uint64_t instructions = 0;
  std::uint32_t crc32 = 0;
};

/// Returns the strip that is drawn after `drawn` others if two cores alternate: first all strips of the first core,
/// then the others.
constexpr std::uint16_t strip_in_turns(std::uint16_t drawn, std::uint16_t strips) {
  const int first = (strips + 1) / 2;
  return static_cast<std::uint16_t>(drawn < first ? 2 * drawn : 2 * (drawn - first) + 1);
}

/// Calls `pose` first, and counts it. `in_turns`: the order of the strips, also for the checksum.
template <class Renderer, class Pose>
FrameResult run_frame(Renderer& renderer, const zstrip::scenes::Staged& staged, const zstrip::View& view,
                      const zstrip::Plan& plan, InstructionCounter& counter, const Pose& pose, bool in_turns = false) {
  const std::span<std::byte> arena(memory, plan.bytes());
  const std::span<std::byte> pixels(memory + plan.bytes(), plan.strip_pixel_bytes(view));
  zstrip::board::Crc32 crc;

  counter.reset();
  counter.resume();
  zstrip::Status status = pose();
  if (status) status = renderer.begin_frame(staged.scene, staged.camera, view, plan, arena);
  counter.pause();
  for (std::uint16_t drawn = 0; status && drawn < plan.strips; ++drawn) {
    const std::uint16_t strip = in_turns ? strip_in_turns(drawn, plan.strips) : drawn;
    counter.resume();
    status = renderer.draw_strip(strip, pixels);
    counter.pause();
    const zstrip::Rect area = plan.strip_area(strip, view);
    const auto width = static_cast<std::uint16_t>(area.width());
    crc.add(pixels.first(static_cast<std::uint32_t>(area.height()) * zstrip::bytes_per_row(width, view.format)));
  }
  return {status, counter.instructions(), crc.value()};
}

inline void print_configuration(const Arguments& arguments, const zstrip::Plan& plan, const zstrip::View& view) {
  print("{\"target\": \"" ZSTRIP_TARGET "\", \"workload\": \"");
  print(arguments.workload);
  print("\", \"mode\": \"");
  print(plan.mode == zstrip::Mode::binned ? "binned" : "streamed");
  print("\"");
  print_member("width", view.width);
  print_member("height", view.height);
  print_member("strip_rows", plan.strip_rows);
  print_member("strip_columns", plan.strip_columns);
  print_member("strips", plan.strips);
  print_member("arena_bytes", plan.bytes());
  print_member("strip_pixel_bytes", plan.strip_pixel_bytes(view));
}

/// Plans are binned if `more` contains effect::bins.
template <const zstrip::scenes::BuiltIn& built_in, zstrip::Effects more = zstrip::Effects{}>
int run(const Arguments& arguments) {
  constexpr zstrip::Effects kEffects = effects_of(built_in.scene, built_in.camera) | more;
  static zstrip::Renderer<kEffects> renderer;
  static zstrip::scenes::Staged staged;

  const zstrip::View view{arguments.width, arguments.height, zstrip::PixelFormat::rgb565};
  const auto [status, plan] =
      zstrip::plan(built_in.counts, view, kEffects,
                   {.bytes = arguments.ram,
                    .strip_rows = arguments.rows,
                    .strip_columns = arguments.columns,
                    .strip_buffers = arguments.buffers,
                    .modes = kEffects.has(zstrip::effect::bins) ? zstrip::Modes::binned : zstrip::Modes::streamed});
  if (!status) return report(status);
  const std::uint32_t needed = plan.bytes() + plan.strip_pixel_bytes(view);
  if (needed < plan.bytes() || needed > sizeof memory) {
    return report({zstrip::Error::arena_too_small, zstrip::Purpose::none, needed, sizeof memory});
  }

  InstructionCounter counter;
  print_configuration(arguments, plan, view);
  print_member("pose_bytes", built_in.pose_bytes);
  print(", \"frames\": [");
  std::uint64_t total = 0;
  for (std::uint32_t frame = 0; frame < arguments.frames; ++frame) {
    stage_workload(built_in, staged, arguments.first + frame);
    // Not called through a pointer: the stack analysis would assume calls of all functions of this type.
    const auto pose = [number = arguments.first + frame] {
      if constexpr (built_in.pose != nullptr) return built_in.pose(number);
      return zstrip::Status{};
    };
    const FrameResult result = run_frame(renderer, staged, view, plan, counter, pose, arguments.in_turns);
    if (!result.status) {
      print("\n");
      return report(result.status);
    }
    print(frame == 0 ? "{\"frame\": " : ", {\"frame\": ");
    print_decimal(arguments.first + frame);
    print_member("instructions", result.instructions);
    print(", \"crc32\": \"");
    print_hex(result.crc32);
    print("\"}");
    total += result.instructions;
  }
  print("]");
  print_member("instructions_per_frame", total / arguments.frames);
  print_member("bin_overflows", renderer.frame().bin_overflows());
  print_member("stack_bytes", zstrip::board::stack_bytes_used());
  print("}\n");
  return kDone;
}

struct Workload {
  std::string_view name;
  std::string_view depth;
  int (*run)(const Arguments&);
};

/// Reads the command line of the program `name`, which has a scene of its own, and calls `run`. Returns the exit
/// status.
inline int run_scene(std::string_view name, int (*run)(const Arguments&)) {
  static std::array<char, 256> buffer;
  const auto words = board::read_command_line(buffer);
  if (!words) return kUsage;
  const Arguments arguments = parse_arguments(*words);
  if (!arguments.wrong_word.empty()) {
    print(name);
    print(": cannot read the word '");
    print(arguments.wrong_word);
    print("'\n");
    return kUsage;
  }
  if (!board::start_instruction_counter()) {
    print(name);
    print(": the timer does not count instructions; run QEMU with -icount shift=0\n");
    return kFailed;
  }
  return run(arguments);
}

inline int run_bench(std::span<const Workload> workloads) {
  static std::array<char, 256> buffer;
  const auto words = board::read_command_line(buffer);
  if (!words) {
    print("bench: no command line from the host, or one of more than 255 characters\n");
    return kUsage;
  }
  const Arguments arguments = parse_arguments(*words);
  if (!arguments.wrong_word.empty()) {
    print("bench: cannot read the word '");
    print(arguments.wrong_word);
    print(
        "'; usage: [workload=K5|K5M|CT|R50|R10k|teapot|room|K5T|character] [depth=FORMAT] [size=WxH] [rows=N] "
        "[columns=N] "
        "[frames=N] [first=N] [buffers=N] [ram=BYTES] [order=down|turns]\n");
    return kUsage;
  }
  for (const Workload& workload : workloads) {
    if (workload.name != arguments.workload || workload.depth != arguments.depth) continue;
    if (!board::start_instruction_counter()) {
      print("bench: the timer does not count instructions; run QEMU with -icount shift=0\n");
      return kFailed;
    }
    return workload.run(arguments);
  }
  print("bench: no workload '");
  print(arguments.workload);
  print("' with depth ");
  print(arguments.depth);
  print("; there are");
  for (const Workload& workload : workloads) {
    print(" ");
    print(workload.name);
    print("/");
    print(workload.depth);
  }
  print("\n");
  return kUsage;
}

}  // namespace zstrip::bench
