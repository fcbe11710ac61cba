// The data of a frame between begin_frame and its strips. Stages read and write it; applications see a Frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "zstrip/base/statistics.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/geometry/bins.hpp"
#include "zstrip/geometry/extent.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/state/depth_ranges.hpp"
#include "zstrip/view.hpp"
#include "zstrip/visibility/method_state.hpp"
#include "zstrip/visibility/triangle_order.hpp"

namespace zstrip::detail {

/// Refers to the caller's scene and arena. All members start as zeros, so that a static renderer takes no flash.
struct FrameState {
  const Scene* scene = nullptr;  ///< null: nothing is drawn until a new frame has begun
  View view{.samples = 0};
  Plan plan{};
  Rect bounds{};  ///< the rectangle that can be drawn into, in pixels of the picture
  Rect depth_area{};
  DepthFit fit{};
  RasterOrigin origin{};
  StripGrid grid{};
  Bins bins{};
  std::uint32_t next_to_last_strip = 0;  ///< one more than the strip drawn last; 0 if none
  Mode mode = Mode::streamed;
  bool has_special_depth = false;
  std::uint32_t bin_overflows = 0;
  CompiledInstance* instances = nullptr;
  Extent* extents = nullptr;  ///< one a meshlet; null for a single streamed strip
  RetainedBatch* batches = nullptr;
  SnappedVertex* vertices = nullptr;
  Colour* colours = nullptr;
  std::uint16_t* depth = nullptr;
  std::uint16_t* working_colour = nullptr;
  Statistics statistics{};
};

struct RangedFrameState : FrameState {
  DepthRanges ranges;
  std::uint32_t cleared_code = 0;
};

struct MethodFrameState : RangedFrameState {
  VisibilityOptions options;
  VisibilityStatistics counts;
  MethodState state;
  SortedTriangle* sorted = nullptr;
  std::uint32_t sorted_count = 0;
  std::byte* depth_bounds = nullptr;
};

template <Effects effects>
using FrameStateFor =
    std::conditional_t<effects.methods != 0, MethodFrameState,
                       std::conditional_t<effects.has(effect::depth_ranges), RangedFrameState, FrameState>>;

/// Refuses several samples in a renderer without effect::supersampled. Nothing is drawn until a new frame has begun.
Status refuse_samples(FrameState& frame);

}  // namespace zstrip::detail
