// The frame as applications may read it, Renderer::frame(): bounds, depth, statistics. Comes with renderer.hpp.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/effects/samples/samples.hpp"
#include "zstrip/stages/frame_state.hpp"

namespace zstrip {

/// Read-only. Refers to its renderer, whose scene and arena are the caller's; a pointer to copy.
class Frame {
 public:
  /// For renderers: applications get it from frame().
  explicit Frame(const detail::FrameState& state) : state_(&state) {}

  /// The smallest rectangle known to hold everything that is drawn, in picture pixels; no more of the z-buffer is
  /// cleared and tested. The plan reserves memory for whole strips.
  const Rect& bounds() const { return state_->bounds; }
  /// As given to begin_frame.
  const View& view() const { return state_->view; }
  /// As given to begin_frame.
  const Plan& plan() const { return state_->plan; }
  /// How this frame is drawn: as planned, or streamed because its bins overflowed.
  Mode mode() const { return state_->mode; }
  /// Frames since construction whose bins overflowed. Their pictures are right, but take longer.
  std::uint32_t bin_overflows() const { return state_->bin_overflows; }
  /// Zeros without effect::statistics.
  const Statistics& statistics() const { return state_->statistics; }
  /// The distance that code 65534 stands for, in view units, 16.16; 0 if nothing is visible.
  Fixed nearest() const { return length_of(state_->fit.near); }
  /// That of code 1.
  Fixed farthest() const { return length_of(state_->fit.far); }
  /// The z-buffer of the strip drawn last: the part of bounds() in that strip, row by row. Empty rectangle if none.
  const std::uint16_t* depth() const { return state_->depth; }
  /// The z-buffer of formats whose cells have 32 bits.
  const std::uint32_t* wide_depth() const { return reinterpret_cast<const std::uint32_t*>(depth()); }
  /// Where depth() lies in the picture: pixels.
  const Rect& depth_area() const { return state_->depth_area; }

  /// True if depth() holds 16-bit codes of which 0 alone is cleared: not with 32-bit formats, sub-ranges or shadows.
  bool has_plain_depth() const { return !state_->has_special_depth; }

  /// True if `strip` is the one that this frame drew last: depth() is its depth.
  bool drew_last(std::uint16_t strip) const { return state_->next_to_last_strip == strip + 1U; }

 protected:
  /// The renderer's state as what it is.
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
  /// For renderers.
  explicit FrameWithDepthRanges(const detail::RangedFrameState& state) : Frame(state) {}
  /// Cells of depth() with this code or a smaller one count as cleared; greater codes are relative to it.
  std::uint16_t cleared_code() const {
    return static_cast<std::uint16_t>(state<detail::RangedFrameState>().cleared_code);
  }
};

/// The frame of a renderer with a visibility method.
class FrameWithMethod : public FrameWithDepthRanges {
 public:
  /// For renderers.
  explicit FrameWithMethod(const detail::MethodFrameState& state) : FrameWithDepthRanges(state) {}
  /// As set by set_visibility before begin_frame.
  const VisibilityOptions& options() const { return state<detail::MethodFrameState>().options; }
  /// Zeros without effect::statistics.
  const VisibilityStatistics& visibility() const { return state<detail::MethodFrameState>().counts; }
  /// With a method that keeps bounds of depth, in the strip drawn last: the farthest code that is known of the 8x8
  /// cells around a pixel of depth_area(), which was drawn into.
  std::uint16_t farthest_known(std::int32_t x, std::int32_t y) const {
    return state<detail::MethodFrameState>().state.bounds.farthest_at(x - (view().width >> 1),
                                                                      y - (view().height >> 1));
  }
};

/// The frame of a renderer with effect::supersampled. Within, all is of the picture of samples; only what is named here
/// is of pixels. So with several samples depth(), depth_area() and all other pixels are samples, statistics()
/// counts them, and has_plain_depth() is false.
template <class Base>
class FrameOfSamples : public Base {
 public:
  using Base::Base;
  /// In pixels, rounded outwards.
  Rect bounds() const { return detail::pixels_of(Base::bounds(), Base::view()); }
  /// As given to begin_frame.
  View view() const { return detail::view_of_pixels(Base::view()); }
  /// As given to begin_frame.
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
