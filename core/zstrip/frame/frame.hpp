// The state of one frame between begin_frame and its strips.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/base/statistics.hpp"
#include "zstrip/effects/samples/samples.hpp"
#include "zstrip/frame/depth_ranges.hpp"
#include "zstrip/geometry/bins.hpp"
#include "zstrip/geometry/extent.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/plan/plan.hpp"
#include "zstrip/scene/view.hpp"
#include "zstrip/visibility/method_state.hpp"
#include "zstrip/visibility/triangle_order.hpp"

namespace zstrip {

/// Read-only for applications. Refers to the caller's scene and arena.
class Frame {
 public:
  /// The smallest rectangle known to hold everything that is drawn, in picture pixels; no more of the z-buffer is
  /// cleared and tested. The plan reserves memory for whole strips.
  const Rect& bounds() const { return bounds_; }
  const View& view() const { return view_; }
  const Plan& plan() const { return plan_; }
  /// How this frame is drawn: as planned, or streamed because its bins overflowed.
  Mode mode() const { return mode_; }
  /// Frames since construction whose bins overflowed. Their pictures are right, but take longer.
  std::uint32_t bin_overflows() const { return bin_overflows_; }
  /// Zeros without effect::statistics.
  const Statistics& statistics() const { return statistics_; }
  /// Distances that codes 65534 and 1 stand for, in view units, 16.16; 0, 0 if nothing is visible.
  Fixed nearest() const { return length_of(fit_.near); }
  Fixed farthest() const { return length_of(fit_.far); }
  /// The z-buffer of the strip drawn last: the part of bounds() in that strip, row by row. Empty rectangle if none.
  const std::uint16_t* depth() const { return depth_; }
  /// The same of formats whose cells have 32 bits.
  const std::uint32_t* wide_depth() const { return reinterpret_cast<const std::uint32_t*>(depth_); }
  const Rect& depth_area() const { return depth_area_; }

  /// Whether depth() holds 16-bit codes of which 0 alone is cleared: not with 32-bit formats, sub-ranges or shadows.
  bool has_plain_depth() const { return !has_special_depth_; }

  /// Whether `strip` is the one that this frame drew last: whose depth depth() is.
  bool drew_last(std::uint16_t strip) const { return next_to_last_strip_ == strip + 1U; }

  struct Access;  // the pipeline's way in

 private:
  friend struct Access;
  const Scene* scene_ = nullptr;
  View view_{.samples = 0};  // all zeros, so that a renderer takes no flash
  Plan plan_{};
  Rect bounds_{};
  Rect depth_area_{};
  DepthFit fit_{};
  detail::RasterOrigin origin_{};
  detail::StripGrid grid_{};
  detail::Bins bins_{};
  std::uint32_t next_to_last_strip_ = 0;  ///< one more than the strip drawn last; 0 if none
  Mode mode_ = Mode::streamed;
  bool has_special_depth_ = false;  // all members start as zeros: a static renderer takes no flash
  std::uint32_t bin_overflows_ = 0;
  detail::CompiledInstance* instances_ = nullptr;
  detail::Extent* extents_ = nullptr;  ///< one a meshlet; null for a single streamed strip
  detail::RetainedBatch* batches_ = nullptr;
  detail::SnappedVertex* vertices_ = nullptr;
  Colour* colours_ = nullptr;
  std::uint16_t* depth_ = nullptr;
  std::uint16_t* working_colour_ = nullptr;
  Statistics statistics_{};
};

/// The frame of a renderer with effect::depth_ranges.
class FrameWithDepthRanges : public Frame {
 public:
  /// Cells of depth() with this code or a smaller one count as cleared; greater codes are relative to it.
  std::uint16_t cleared_code() const { return static_cast<std::uint16_t>(cleared_code_); }

 private:
  friend struct Frame::Access;
  detail::DepthRanges ranges_;
  std::uint32_t cleared_code_ = 0;
};

/// The frame of a renderer with a visibility method.
class FrameWithMethod : public FrameWithDepthRanges {
 public:
  const VisibilityOptions& options() const { return options_; }
  void set_options(const VisibilityOptions& options) { options_ = options; }
  /// Zeros without effect::statistics.
  const VisibilityStatistics& visibility() const { return counts_; }
  /// Of the strip drawn last, with a method that keeps bounds of depth: the farthest code that is known of the 8x8
  /// cells around a pixel of depth_area(), which was drawn into.
  std::uint16_t farthest_known(std::int32_t x, std::int32_t y) const {
    return state_.bounds.farthest_at(x - (view().width >> 1), y - (view().height >> 1));
  }

 private:
  friend struct Frame::Access;
  VisibilityOptions options_;
  VisibilityStatistics counts_;
  detail::MethodState state_;
  detail::SortedTriangle* sorted_ = nullptr;
  std::uint32_t sorted_count_ = 0;
  std::byte* depth_bounds_ = nullptr;
};

namespace detail {
/// What a renderer without effect::supersampled says to a view with several samples a pixel. The frame draws nothing
/// until the next that can begin.
Status refuse_samples(Frame& frame);
}  // namespace detail

/// The frame of a renderer with effect::supersampled. Within, all is of the picture of samples; only what is named here
/// is of pixels. So with several samples depth(), depth_area() and what else says pixels means samples, statistics()
/// counts them, and has_plain_depth() is false.
template <class Base>
class FrameOfSamples : public Base {
 public:
  Rect bounds() const { return detail::pixels_of(Base::bounds(), Base::view()); }
  View view() const { return detail::view_of_pixels(Base::view()); }
  Plan plan() const { return detail::plan_of_pixels(Base::plan(), Base::view()); }
};

namespace detail {
template <Effects effects>
using PlainFrameFor =
    std::conditional_t<effects.methods != 0, FrameWithMethod,
                       std::conditional_t<effects.has(effect::depth_ranges), FrameWithDepthRanges, Frame>>;
}  // namespace detail

/// What a renderer with these effects holds.
template <Effects effects>
using FrameFor = std::conditional_t<effects.has(effect::supersampled), FrameOfSamples<detail::PlainFrameFor<effects>>,
                                    detail::PlainFrameFor<effects>>;

}  // namespace zstrip
