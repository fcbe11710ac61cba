// The codes of a strip with its apron, while the second pass of shadows changes the z-buffer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "zstrip/effects/edges/apron.hpp"

namespace zstrip::detail::edges {

/// Saves the codes in the strip's pixels, which nothing uses until edges are blended. Those of the apron find no room
/// there and follow the other pixels of the working strip; see saved_bytes_of_edges.
class SavedDepth {
 public:
  SavedDepth(const FrameState& frame, const StripTarget& target, const StripImage& image)
      : depth_(target.depth), cells_(cells_of(target.area)) {
    const std::size_t pixels = cells_of(frame.plan.strip_area(image.strip, frame.view));
    saved_[0] = blended_pixels(frame, image);
    saved_[1] = frame.working_colour + cells_of(image.area) + (drawn_in_place(frame.view.format) ? 0 : pixels);
    first_ = std::min(cells_, pixels);
    __builtin_memcpy(saved_[0], depth_, first_ * kDepthBytes);
    __builtin_memcpy(saved_[1], depth_ + first_, (cells_ - first_) * kDepthBytes);
  }
  void restore() const {
    __builtin_memcpy(depth_, saved_[0], first_ * kDepthBytes);
    __builtin_memcpy(depth_ + first_, saved_[1], (cells_ - first_) * kDepthBytes);
  }

 private:
  std::uint16_t* depth_;
  std::size_t cells_, first_;  ///< all, and those in saved_[0]
  std::uint16_t* saved_[2];
};

}  // namespace zstrip::detail::edges
