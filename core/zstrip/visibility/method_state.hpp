// The state of a visibility method while a strip is drawn; stages and pixel loops read it.
#pragma once

#include <cstdint>

#include "zstrip/visibility/depth_bounds.hpp"
#include "zstrip/visibility/options.hpp"

namespace zstrip::detail {

struct MethodState {
  VisibilityStatistics* counts = nullptr;  ///< null without effect::statistics
  DepthBounds bounds;                      ///< bounds of method::bounded for the current strip
  std::uint8_t iterations = 0;
  bool cull_small = true;
  bool keeps_order = false;                   ///< some material has a depth test, write or bias of its own
  const std::uint16_t* first_cell = nullptr;  ///< first cell of the strip's z-buffer; with the painter, first pixel
  std::uint8_t* overdraw = nullptr;           ///< VisibilityOptions::overdraw
};

}  // namespace zstrip::detail
