// Measures the rows of the dynamic z-buffer's table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/dynamic_z.hpp"
#include "result.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// One row: a picture with one z-buffer.
struct DynamicZRow {
  DynamicZPicture picture{};
  DepthMemory memory = DepthMemory::classic;
  View view{};
  Plan plan{};
  std::uint32_t allowed_bytes = 0;              ///< 0: as many as the plan took
  std::uint32_t pixel_bytes = 0;                ///< a buffer for one strip
  std::uint32_t crc32 = 0;                      ///< zlib's CRC-32 of the drawn picture, in the middle of the judge's
  std::uint32_t vertices = 0;                   ///< transformed: once in the survey, again for each strip
  bool right = false;                           ///< the CRC-32 is that of the judge's picture
  std::optional<std::uint64_t> instructions{};  ///< of one frame; nothing if valgrind cannot count them
  double nanoseconds = 0;                       ///< of one frame, minimum of several
};

/// Measures all rows of these pictures, in the order of kDepthMemories. Takes seconds for each; shows progress on
/// stderr.
Result<std::vector<DynamicZRow>> measure_dynamic_z(std::span<const DynamicZPicture> pictures);

/// Draws a row `draws` times without measurements; this runs under valgrind.
Result<Done> draw_dynamic_z_only(const DynamicZPicture& picture, DepthMemory memory, std::uint32_t draws);

/// Returns the row to compare with: the row of the same picture before it that draws the same pixels, classic for
/// `rectangle` and `rectangle` for the rows with little memory. Null for classic, and if the classic picture is not
/// right.
const DynamicZRow* compared_with(const DynamicZRow& row, std::span<const DynamicZRow> rows);

/// Returns the ratio of instructions, or of time if instructions are not known.
double work_ratio(const DynamicZRow& row, const DynamicZRow& other);

/// Returns the table for display, with the paper's figures next to ours, and the rows that were compared.
std::string dynamic_z_text(std::span<const DynamicZRow> rows);

/// Returns an array with one object for each row; bench/README.md documents the keys.
std::string dynamic_z_json(std::span<const DynamicZRow> rows);

}  // namespace zstrip::sim
