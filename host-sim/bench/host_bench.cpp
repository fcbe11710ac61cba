// Rounds of timed frames, one pass for the checksums, and the instruction counts.
#include "bench/host_bench.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <span>

#include "bench/drawing.hpp"
#include "bench/instruction_count.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kTimedRounds = 9;

Failure drawing_failure(const BenchCase& bench_case, const Status& status) {
  return {ExitStatus::internal, fmt::format("{} could not be drawn: {}", bench_case.workload, message(status.error))};
}

Result<std::vector<std::uint32_t>> checksums(Drawing& drawing, const BenchCase& bench_case) {
  std::vector<std::uint32_t> sums;
  for (std::uint32_t frame = 0; frame < bench_case.frames; ++frame) {
    uLong sum = ::crc32(0, nullptr, 0);
    drawing.stage(frame);
    const Status drawn = drawing.draw([&sum](std::span<const std::byte> pixels) {
      sum = ::crc32(sum, reinterpret_cast<const Bytef*>(pixels.data()), static_cast<uInt>(pixels.size()));
    });
    if (!drawn) return drawing_failure(bench_case, drawn);
    sums.push_back(static_cast<std::uint32_t>(sum));
  }
  return sums;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Result<double> nanoseconds_per_frame(Drawing& drawing, const BenchCase& bench_case) {
  std::chrono::nanoseconds spent{0};
  for (std::uint32_t frame = 0; frame < bench_case.frames; ++frame) {
    drawing.stage(frame);
    const auto begin = std::chrono::steady_clock::now();
    const Status drawn = drawing.draw();
    spent += std::chrono::steady_clock::now() - begin;
    if (!drawn) return drawing_failure(bench_case, drawn);
  }
  return static_cast<double>(spent.count()) / bench_case.frames;
}

Result<std::vector<Measurement>> bench_on_host(const std::vector<BenchCase>& cases) {
  std::vector<Drawing> drawings;
  std::vector<Measurement> rows;
  for (const BenchCase& bench_case : cases) {
    Result<Drawing> drawing = Drawing::prepare(bench_case);
    if (!drawing) return drawing.failure();
    drawings.push_back(std::move(*drawing));
    Result<std::vector<std::uint32_t>> sums = checksums(drawings.back(), bench_case);
    if (!sums) return sums.failure();
    rows.push_back({.bench_case = bench_case,
                    .mode = drawings.back().plan().mode,
                    .strip_rows = drawings.back().plan().strip_rows,
                    .strip_columns = drawings.back().plan().strip_columns,
                    .ram_bytes = drawings.back().ram_bytes(),
                    .frame_crc32 = std::move(*sums)});
  }

  std::vector<std::vector<double>> times(cases.size());
  for (std::size_t round = 0; round < kTimedRounds; ++round) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const Result<double> time = nanoseconds_per_frame(drawings[i], cases[i]);
      if (!time) return time.failure();
      times[i].push_back(*time);
    }
  }
  for (std::size_t i = 0; i < cases.size(); ++i) {
    rows[i].nanoseconds_per_frame = median(std::move(times[i]));
    const Result<std::optional<std::uint64_t>> instructions = count_instructions(cases[i]);
    if (!instructions) return instructions.failure();
    rows[i].instructions_per_frame = *instructions;
  }
  return rows;
}

Result<Done> draw_only(const BenchCase& bench_case, std::uint32_t draws) {
  Result<Drawing> drawing = Drawing::prepare(bench_case);
  if (!drawing) return drawing.failure();
  for (std::uint32_t frame = 0; frame < bench_case.frames; ++frame) {
    drawing->stage(frame);
    for (std::uint32_t i = 0; i < draws; ++i) {
      if (const Status drawn = drawing->draw(); !drawn) return drawing_failure(bench_case, drawn);
    }
  }
  return Done{};
}

}  // namespace zstrip::sim
