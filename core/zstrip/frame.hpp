// The frame that an application reads through Renderer::frame(): bounds, depth, statistics. renderer.hpp includes it.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/effects/samples/samples.hpp"
#include "zstrip/state/frame_state.hpp"

namespace zstrip {

/// Read-only, and as small as a pointer. Refers to its renderer; the renderer's scene and arena are the caller's.
class Frame {
 public:
  /// Renderers call it; applications get a frame from frame().
  explicit Frame(const detail::FrameState& state) : state_(&state) {}

  /// The smallest rectangle known to hold everything that is drawn, in picture pixels; only this part of the z-buffer
  /// is cleared and tested. The plan reserves memory for whole strips.
  const Rect& bounds() const { return state_->bounds; }
  /// Returns the view that begin_frame got.
  const View& view() const { return state_->view; }
  /// Returns the plan that begin_frame got.
  const Plan& plan() const { return state_->plan; }
  /// Returns the mode in which this frame is drawn: the planned one, or streamed because the bins overflowed.
  Mode mode() const { return state_->mode; }
  /// Returns the number of frames since construction whose bins overflowed. Their pictures are right, but take longer.
  std::uint32_t bin_overflows() const { return state_->bin_overflows; }
  /// All counts are 0 without effect::statistics.
  const Statistics& statistics() const { return state_->statistics; }
  /// Returns the distance that code 65534 stands for, in view units, 16.16; 0 if nothing is visible.
  Fixed nearest() const { return length_of(state_->fit.near); }
  /// Returns the distance that code 1 stands for.
  Fixed farthest() const { return length_of(state_->fit.far); }
  /// The z-buffer of the strip drawn last: the part of bounds() in that strip, row by row. Empty rectangle if none.
  const std::uint16_t* depth() const { return state_->depth; }
  /// The z-buffer of formats with 32-bit cells.
  const std::uint32_t* wide_depth() const { return reinterpret_cast<const std::uint32_t*>(depth()); }
  /// The rectangle of the picture that depth() covers, in pixels.
  const Rect& depth_area() const { return state_->depth_area; }

  /// True if depth() holds 16-bit codes and only 0 means cleared: false with 32-bit formats, sub-ranges or shadows.
  bool has_plain_depth() const { return !state_->has_special_depth; }

  /// True if this frame drew `strip` last, so that depth() is the depth of `strip`.
  bool drew_last(std::uint16_t strip) const { return state_->next_to_last_strip == strip + 1U; }

 protected:
  /// Returns the renderer's state as its actual type.
  template <class State>
  const State& state() const {
    return static_cast<const State&>(*state_);
  }

 private:
  const detail::FrameState* state_;
};

/// The frame of a renderer with effect::depth_ranges.
class FrameWithDepthRanges : public Frame {
 public:
  /// Renderers call it.
  explicit FrameWithDepthRanges(const detail::RangedFrameState& state) : Frame(state) {}
  /// Cells of depth() with this code or a smaller one count as cleared; greater codes are relative to it.
  std::uint16_t cleared_code() const {
    return static_cast<std::uint16_t>(state<detail::RangedFrameState>().cleared_code);
  }
};

/// The frame of a renderer with a visibility method.
class FrameWithMethod : public FrameWithDepthRanges {
 public:
  /// Renderers call it.
  explicit FrameWithMethod(const detail::MethodFrameState& state) : FrameWithDepthRanges(state) {}
  /// Returns the options that set_visibility set before begin_frame.
  const VisibilityOptions& options() const { return state<detail::MethodFrameState>().options; }
  /// All counts are 0 without effect::statistics.
  const VisibilityStatistics& visibility() const { return state<detail::MethodFrameState>().counts; }
  /// Returns the farthest code known for the 8x8 cells around a pixel (x, y) of depth_area(), in the strip drawn last.
  /// The pixel must have been drawn into, and the method must keep bounds of depth.
  std::uint16_t farthest_known(std::int32_t x, std::int32_t y) const {
    return state<detail::MethodFrameState>().state.bounds.farthest_at(x - (view().width >> 1),
                                                                      y - (view().height >> 1));
  }
};

/// The frame of a renderer with effect::supersampled. The members below are in pixels; with several samples a pixel all
/// others are in samples: depth() and depth_area() hold samples, statistics() counts them, and has_plain_depth() is
/// false.
template <class Base>
class FrameOfSamples : public Base {
 public:
  using Base::Base;
  /// Returns pixels, rounded outwards.
  Rect bounds() const { return detail::pixels_of(Base::bounds(), Base::view()); }
  /// Returns the view that begin_frame got.
  View view() const { return detail::view_of_pixels(Base::view()); }
  /// Returns the plan that begin_frame got.
  Plan plan() const { return detail::plan_of_pixels(Base::plan(), Base::view()); }
};

namespace detail {
template <Effects effects>
using PlainFrameFor =
    std::conditional_t<effects.methods != 0, FrameWithMethod,
                       std::conditional_t<effects.has(effect::depth_ranges), FrameWithDepthRanges, Frame>>;
}  // namespace detail

/// The frame of a renderer with these effects.
template <Effects effects>
using FrameFor = std::conditional_t<effects.has(effect::supersampled), FrameOfSamples<detail::PlainFrameFor<effects>>,
                                    detail::PlainFrameFor<effects>>;

}  // namespace zstrip
