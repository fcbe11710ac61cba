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
  bool right = false;                           ///< it is the CRC-32 of the judge's picture
  std::optional<std::uint64_t> instructions{};  ///< of one frame; absent where valgrind cannot count them
  double nanoseconds = 0;                       ///< of one frame, least of several
};

/// All rows of these pictures, in the order of kDepthMemories. Takes seconds for each; shows on stderr how far it is.
Result<std::vector<DynamicZRow>> measure_dynamic_z(std::span<const DynamicZPicture> pictures);

/// Draws a row `draws` times, measuring nothing: what runs under valgrind.
Result<Done> draw_dynamic_z_only(const DynamicZPicture& picture, DepthMemory memory, std::uint32_t draws);

/// What a row's work is compared with: the picture's row before that draws the same pixels, classic for `rectangle` and
/// `rectangle` for the rows in little memory. Null for classic, and where the classic picture is not right.
const DynamicZRow* compared_with(const DynamicZRow& row, std::span<const DynamicZRow> rows);

/// Of instructions, or of time where these are absent.
double work_ratio(const DynamicZRow& row, const DynamicZRow& other);

/// The table for people, with the paper's figures beside ours, and what was compared with what.
std::string dynamic_z_text(std::span<const DynamicZRow> rows);

/// An array with one object a row; the keys are documented in bench/README.md.
std::string dynamic_z_json(std::span<const DynamicZRow> rows);

}  // namespace zstrip::sim
