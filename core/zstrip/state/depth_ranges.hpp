// Sub-ranges of the z-buffer's codes, so that few strips need a clear. All codes of a strip are greater, and so nearer,
// than the codes that earlier strips left in its cells. The strip after the last sub-range is cleared and uses the
// first one.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/geometry/depth_mapping.hpp"

namespace zstrip::detail {

/// The state of the z-buffer's memory between strips: its first `known_` cells hold no code above the current
/// sub-range. Rectangles differ, but each uses the first cells, so that a count is enough.
class DepthRanges {
 public:
  DepthRanges() = default;
  /// A copy knows no cells: two objects would write the same memory without knowing of each other.
  DepthRanges(const DepthRanges&) {}
  DepthRanges& operator=(const DepthRanges& other) {
    if (this != &other) cells_ = nullptr;
    return *this;
  }

  /// A frame's z-buffer lies at `cells`, with room for `room` cells. All other memory may be written by others.
  void begin_frame(const std::uint16_t* cells, std::uint32_t room) {
    known_ = cells == cells_ ? std::min(known_, room) : 0;
    cells_ = cells;
  }

  /// Begins a strip of `count` cells (> 0). Returns how many of them, from the first one on, need no clear.
  std::uint32_t next(std::uint32_t count) {
    if (++range_ >= kDepthRanges) range_ = known_ = 0;
    const std::uint32_t usable = std::min(known_, count);
    known_ = std::max(known_, count);
    return usable;
  }

  /// Returns the code that means cleared; fragments have greater codes.
  std::uint32_t cleared_code() const { return range_ * kDepthRangeCodes; }

 private:
  const std::uint16_t* cells_ = nullptr;
  std::uint32_t known_ = 0;
  std::uint32_t range_ = 0;
};

}  // namespace zstrip::detail
