// Sub-ranges of the z-buffer's codes, so that not every strip needs a clear: each strip's codes are all greater, and so
// nearer, than any that an earlier strip left in its cells. After the last sub-range the first begins with a clear.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/geometry/depth_mapping.hpp"

namespace zstrip::detail {

/// State of the z-buffer's memory between strips: its first cells hold no code above the current sub-range.
/// Rectangles move, but the cells of each are the first ones, so that a count is enough.
class DepthRanges {
 public:
  DepthRanges() = default;
  /// A copy would be a second writer of the same cells: it starts without any.
  DepthRanges(const DepthRanges&) {}
  DepthRanges& operator=(const DepthRanges& other) {
    if (this != &other) cells_ = nullptr;
    return *this;
  }

  /// A frame's z-buffer lies at `cells`, with room for `room` of them. What lies elsewhere, or beyond, others may
  /// write.
  void begin_frame(const std::uint16_t* cells, std::uint32_t room) {
    known_ = cells == cells_ ? std::min(known_, room) : 0;
    cells_ = cells;
  }

  /// The next strip has this many cells (> 0). Returns how many of them, the first ones, need no clear.
  std::uint32_t next(std::uint32_t count) {
    if (++range_ >= kDepthRanges) range_ = known_ = 0;
    const std::uint32_t usable = std::min(known_, count);
    known_ = std::max(known_, count);
    return usable;
  }

  /// The code that stands for a cleared cell: fragments have greater ones.
  std::uint32_t cleared_code() const { return range_ * kDepthRangeCodes; }

 private:
  const std::uint16_t* cells_ = nullptr;
  std::uint32_t known_ = 0;
  std::uint32_t range_ = 0;
};

}  // namespace zstrip::detail
