// Waits for what each program reports and looks at the painted stack.
#include "board_run.hpp"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "pico/figures.hpp"
#include "qemu.hpp"

namespace zstrip::budget {
namespace {

using boards::Qemu;

/// Rows of a strip of the benchmarks.
constexpr int kBenchRows = 16;

nlohmann::json parse_report(const std::string& line) {
  const auto report = nlohmann::json::parse(line, nullptr, false);
  if (!report.is_object()) throw std::runtime_error("the program reports: " + line);
  return report;
}

/// Bytes from the top of the stack to the deepest word that is not what the start-up code painted it with.
std::uint32_t painted_high_water(Qemu& emulator, const Section& stack) {
  constexpr std::uint32_t kPaint = 0xDEADBEEF;
  const std::vector<std::byte> memory = emulator.memory(stack.address, stack.size);
  std::uint32_t untouched = 0;
  for (; untouched + 4 <= memory.size(); untouched += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, memory.data() + untouched, sizeof word);
    if (word != kPaint) break;
  }
  return stack.size - untouched;
}

BoardRun plan_of(const nlohmann::json& report) {
  return {.stack = report.at("stack_bytes"),
          .arena = report.at("arena_bytes"),
          .pixels = report.at("strip_pixel_bytes"),
          .strip_rows = report.at("strip_rows"),
          .strip_columns = report.at("strip_columns")};
}

BoardRun run_turntable(Qemu& emulator, const Section& stack) {
  const BoardRun run = plan_of(parse_report(emulator.read_line()));
  const std::uint32_t seen = painted_high_water(emulator, stack);
  if (seen != run.stack) {
    throw std::runtime_error("the program reports " + std::to_string(run.stack) + " bytes of stack, its memory says " +
                             std::to_string(seen));
  }
  return run;
}

BoardRun run_bench(Qemu& emulator) {
  const auto [output, status] = emulator.finish(Qemu::Duration(300'000));
  if (status != 0) throw std::runtime_error("the benchmark ended with " + std::to_string(status) + ": " + output);
  return plan_of(parse_report(output));
}

BoardRun run_frames(Qemu& emulator, const Section& stack, int frames) {
  emulator.prompt("p");
  for (int frame = 1; frame < frames; ++frame) {
    emulator.write_console("n");
    emulator.read_line();
  }
  return {.stack = painted_high_water(emulator, stack)};
}

std::uint32_t recorded_stack(const Target& target) {
  const measured::Table table = measured::read_table(pico::kFiguresFile, pico::figures_format());
  const measured::Row* const row = table.find({target.program, target.scene});
  if (row == nullptr) throw std::runtime_error(std::string("pico.csv has no row of ") + target.program);
  return static_cast<std::uint32_t>(std::stoul(row->back()));
}

}  // namespace

BoardRun run_on_board(const Target& target, const std::filesystem::path& program, const Section& stack) {
  if (target.report == Report::none) return {};
  if (target.report == Report::recorded) return {.stack = recorded_stack(target)};
  Qemu::Options options{.machine = target.machine, .program = program, .serial_port = target.serial_port};
  if (target.report == Report::bench) {
    options.words = {std::string("workload=") + target.workload,
                     "size=" + std::to_string(target.view.width) + "x" + std::to_string(target.view.height),
                     "rows=" + std::to_string(kBenchRows)};
    options.count_instructions = true;
  }
  Qemu emulator(options);
  switch (target.report) {
    case Report::turntable: return run_turntable(emulator, stack);
    case Report::bench: return run_bench(emulator);
    case Report::none:
    case Report::recorded: break;
    case Report::frames: return run_frames(emulator, stack, target.frames);
  }
  throw std::runtime_error("a report of no kind");
}

}  // namespace zstrip::budget
