// Runs each workload with each method, and compares them.
#include "bench/board_visibility.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/board_bench.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kFrames = 4;
constexpr const char* kLine = "{:<8} {:<15} {:<6} {:>14} {:>8} {:>10}\n";

std::uint64_t instructions(const Measurement& row) { return row.instructions_per_frame.value_or(0); }

/// Returns the row of the plain z-buffer with the same workload and target; it comes before the rows of the methods.
const Measurement& plain(std::span<const Measurement> rows, std::size_t index) {
  while (index > 0 && rows[index].bench_case.depth != "zbuffer") --index;
  return rows[index];
}

}  // namespace

std::vector<BenchCase> board_visibility_cases() {
  std::vector<BenchCase> cases;
  for (const char* workload : {"K5", "CT", "room", "crowd"}) {
    for (const char* target : {"m0", "m3"}) {
      for (const char* method : {"zbuffer", "front-to-back", "hierarchical-z", "painter", "midpoint-safe"}) {
        BenchCase bench_case{.workload = workload,
                             .target = target,
                             .view = {320, 240, PixelFormat::rgb565},
                             .budget = {},
                             .depth = method,
                             .frames = kFrames,
                             .program = fmt::format("zstrip_bench_visibility_{}", target)};
        bench_case.budget.strip_rows = 16;
        bench_case.budget.modes = Modes::streamed;
        cases.push_back(bench_case);
      }
    }
  }
  return cases;
}

Result<std::vector<Measurement>> measure_board_visibility(const std::string& firmware) {
  return bench_on_board(board_visibility_cases(), firmware);
}

std::string board_visibility_text(std::span<const Measurement> rows) {
  std::string text =
      fmt::format(fmt::runtime(kLine), "scene", "method", "target", "instructions", "ratio", "RAM, bytes");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Measurement& row = rows[i];
    const double ratio = static_cast<double>(instructions(row)) / static_cast<double>(instructions(plain(rows, i)));
    text += fmt::format(fmt::runtime(kLine), row.bench_case.workload, row.bench_case.depth, row.bench_case.target,
                        grouped(instructions(row)), fmt::format("{:.2f}", ratio), grouped(row.ram_bytes));
  }
  return text +
         "Instructions of a frame, 320x240 in strips of 16 rows, the mean of the first four; ratio to zbuffer.\n"
         "RAM: arena and one strip of pixels.\n";
}

std::string board_visibility_json(std::span<const Measurement> rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Measurement& row : rows) {
    list.push_back({{"table", "boards"},
                    {"scene", row.bench_case.workload},
                    {"method", row.bench_case.depth},
                    {"target", row.bench_case.target},
                    {"instructions_per_frame", instructions(row)},
                    {"ram_bytes", row.ram_bytes}});
  }
  return list.dump(2) + "\n";
}

}  // namespace zstrip::sim
