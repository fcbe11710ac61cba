// Draws, compares, times and counts the rows of the dynamic z-buffer's table.
#include "bench/dynamic_z_table.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "bench/instruction_count.hpp"
#include "text/progress.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kRatioRounds = 25;

Failure drawing_failure(const DynamicZPicture& picture, const Status& status) {
  return {ExitStatus::internal,
          fmt::format("the picture of {0}x{0} could not be drawn: {1}", picture.side, message(status.error))};
}

Result<std::uint32_t> checksum(DynamicZDrawing& drawing, const DynamicZPicture& picture,
                               std::vector<std::uint16_t>& pixels) {
  if (const Status status = drawing.draw_into(pixels); !status) return drawing_failure(picture, status);
  const auto bytes = std::as_bytes(std::span(pixels));
  return static_cast<std::uint32_t>(
      ::crc32(::crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

// The minimum of all rounds, because other load of the machine only adds time. Rounds alternate between the rows, so
// that a slow period affects all of them.
Result<Done> time_rows(std::vector<DynamicZDrawing>& drawings, std::span<DynamicZRow> rows) {
  for (std::size_t round = 0; round < kRatioRounds; ++round) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto begin = std::chrono::steady_clock::now();
      const Status drawn = drawings[i].draw();
      const std::chrono::nanoseconds spent = std::chrono::steady_clock::now() - begin;
      if (!drawn) return drawing_failure(rows[i].picture, drawn);
      const auto nanoseconds = static_cast<double>(spent.count());
      if (round == 0 || nanoseconds < rows[i].nanoseconds) rows[i].nanoseconds = nanoseconds;
    }
  }
  return Done{};
}

Result<std::optional<std::uint64_t>> instructions_of(const DynamicZRow& row) {
  return count_draw({"--table", "dynamic-z", "--picture", std::to_string(row.picture.side), "--depth-memory",
                     std::string(name(row.memory))},
                    fmt::format("the picture of {0}x{0}", row.picture.side));
}

// Rows without instructions.
Result<std::vector<DynamicZRow>> drawn_rows(const TorusKnot& knot, const DynamicZPicture& picture) {
  std::vector<std::uint16_t> pixels;
  Result<DynamicZDrawing> judge = DynamicZDrawing::prepare_judge(knot, picture);
  if (!judge) return judge.failure();
  const Result<std::uint32_t> judged = checksum(*judge, picture, pixels);
  if (!judged) return judged.failure();

  std::vector<DynamicZDrawing> drawings;
  std::vector<DynamicZRow> rows;
  for (const DepthMemory memory : kDepthMemories) {
    Result<DynamicZDrawing> drawing = DynamicZDrawing::prepare(knot, picture, memory);
    if (!drawing) return drawing.failure();
    const Result<std::uint32_t> drawn = checksum(*drawing, picture, pixels);
    if (!drawn) return drawn.failure();
    const Result<Statistics> work = drawing->count_work();
    if (!work) return work.failure();
    rows.push_back({.picture = picture,
                    .memory = memory,
                    .view = drawing->view(),
                    .plan = drawing->plan(),
                    .allowed_bytes = budget_of(picture, memory).bytes,
                    .pixel_bytes = drawing->pixel_bytes(),
                    .crc32 = *drawn,
                    .vertices = work->vertices,
                    .right = *drawn == *judged});
    drawings.push_back(std::move(*drawing));
  }
  if (Result<Done> timed = time_rows(drawings, rows); !timed) return timed.failure();
  return rows;
}

}  // namespace

Result<std::vector<DynamicZRow>> measure_dynamic_z(std::span<const DynamicZPicture> pictures) {
  const TorusKnot knot;
  std::vector<DynamicZRow> rows;
  Progress progress(static_cast<std::uint32_t>(pictures.size() * std::size(kDepthMemories)), true, "row");
  for (const DynamicZPicture& picture : pictures) {
    Result<std::vector<DynamicZRow>> drawn = drawn_rows(knot, picture);
    if (!drawn) return drawn.failure();
    for (DynamicZRow& row : *drawn) {
      progress.show(static_cast<std::uint32_t>(rows.size()));
      const Result<std::optional<std::uint64_t>> instructions = instructions_of(row);
      if (!instructions) return instructions.failure();
      row.instructions = *instructions;
      rows.push_back(row);
    }
  }
  return rows;
}

Result<Done> draw_dynamic_z_only(const DynamicZPicture& picture, DepthMemory memory, std::uint32_t draws) {
  const TorusKnot knot;
  Result<DynamicZDrawing> drawing = DynamicZDrawing::prepare(knot, picture, memory);
  if (!drawing) return drawing.failure();
  for (std::uint32_t i = 0; i < draws; ++i) {
    if (const Status drawn = drawing->draw(); !drawn) return drawing_failure(picture, drawn);
  }
  return Done{};
}

const DynamicZRow* compared_with(const DynamicZRow& row, std::span<const DynamicZRow> rows) {
  if (row.memory == DepthMemory::classic) return nullptr;
  const DepthMemory other = row.memory == DepthMemory::rectangle ? DepthMemory::classic : DepthMemory::rectangle;
  const auto found = std::ranges::find_if(rows, [&](const DynamicZRow& candidate) {
    return candidate.picture.side == row.picture.side && candidate.memory == other;
  });
  return found != rows.end() && found->right ? &*found : nullptr;
}

double work_ratio(const DynamicZRow& row, const DynamicZRow& other) {
  if (row.instructions && other.instructions) {
    return static_cast<double>(*row.instructions) / static_cast<double>(*other.instructions);
  }
  return row.nanoseconds / other.nanoseconds;
}

}  // namespace zstrip::sim
