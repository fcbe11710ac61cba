// The state of a visibility method while a strip is drawn: where stages and pixel loops find it.
#pragma once

#include <cstdint>

#include "zstrip/visibility/depth_bounds.hpp"
#include "zstrip/visibility/options.hpp"

namespace zstrip::detail {

struct MethodState {
  VisibilityStatistics* counts = nullptr;  ///< null without effect::statistics
  DepthBounds bounds;                      ///< of method::bounded, of the strip being drawn
  std::uint8_t iterations = 0;
  bool cull_small = true;
  bool keeps_order = false;                   ///< some material has a depth test, write or bias of its own
  const std::uint16_t* first_cell = nullptr;  ///< of the strip's z-buffer; of its pixels with the painter
  std::uint8_t* overdraw = nullptr;           ///< VisibilityOptions::overdraw
};

}  // namespace zstrip::detail
