// The renderer that applications use: begin_frame once, draw_strip for each strip. AnyRenderer, for effects that are
// known at run time, needs the library zstrip::core_any.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/frame.hpp"
#include "zstrip/frame/begin_frame.hpp"
#include "zstrip/frame/pipeline.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/scene/validate.hpp"  // call it before begin_frame

namespace zstrip {

/// Draws scenes that need no other effects than `effects`. Firmware instantiates exactly one:
///     constexpr Effects kEffects = effects_of(scene, camera);
///     Renderer<kEffects> renderer;
/// Holds no pixels and no heap: some hundred bytes. Not safe for two threads at once; separate objects with separate
/// arenas are independent.
template <Effects effects>
class Renderer {
  static_assert(effects_agree(effects), "effects that go together: kExclusions, kAlternatives");
  static_assert(methods_agree(effects), "visibility methods that go together and can draw these effects: kExclusions");

 public:
  /// Checks all arguments that could cause a wrong memory access, then prepares the frame. `arena`: at least
  /// plan.bytes(), aligned to kArenaAlignment, its contents do not matter. Scene and arena must stay alive and
  /// unchanged until the last draw_strip of this frame. On an error the renderer draws nothing until the next success.
  /// With effect::depth_ranges the arena's contents do matter between frames: if begin_frame gets an arena with the
  /// same start and layout as the last one, only this object may have written it since. If something else wrote it,
  /// such as another renderer, assign a new object first.
  Status begin_frame(const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                     std::span<std::byte> arena) {
    // The test stands here, where a constant view removes it.
    if (!effects.has(effect::supersampled) && view.samples != 1) return detail::refuse_samples(state_);
    return detail::begin_frame<effects>(state_, scene, camera, view, plan, arena);
  }
  /// Draws plan.strip_area(strip, view) of the picture into `pixels` (at most plan.strip_pixel_bytes(view), aligned to
  /// 2 for RGB565; their contents do not matter). The last strips of a row or column may be smaller. Strips may be
  /// drawn in any order, or again.
  Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    return detail::draw_strip<effects>(state_, strip, pixels);
  }
  /// Draws the part of the frame in `area` (pixels of the picture) over the existing pixels: area.width() *
  /// area.height() pixels in RGB565, whatever the view's format, and as many depth codes, without gaps. For layers:
  /// depths can be compared only between frames with the same camera, Camera::fixed_depth_range and the same depth
  /// format. Error::view_size if the area is empty or leaves the picture, Error::pixels_too_small, Error::depth_effects
  /// if depth has no 16-bit cells or has sub-ranges, Error::samples if pixels have several samples.
  Status draw_over(const Rect& area, std::span<std::uint16_t> pixels, std::span<std::uint16_t> depth) {
    return detail::draw_over<effects>(state_, area, pixels, depth);
  }
  /// Returns the frame that was begun last. It refers to this object.
  FrameFor<effects> frame() const { return FrameFor<effects>(state_); }
  /// Applies from the next begin_frame on.
  void set_visibility(const VisibilityOptions& options) requires(effects.methods != 0) { state_.options = options; }

 private:
  detail::FrameStateFor<effects> state_;
};

/// A renderer for programs that know the effects only at run time. Costs one indirect call a frame and a strip.
class AnyRenderer {
 public:
  /// Selects the pipeline with exactly these effects. With a depth effect it selects one with all other effects as
  /// well, which draws the same pixels.
  explicit AnyRenderer(Effects effects)
      : pipeline_(pipeline_for(effects)), takes_samples_(effects.has(effect::supersampled)) {}
  /// See Renderer::begin_frame.
  Status begin_frame(const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                     std::span<std::byte> arena) {
    if (!takes_samples_ && view.samples != 1) return detail::refuse_samples(state_);
    return pipeline_.begin_frame(state_, scene, camera, view, plan, arena);
  }
  /// See Renderer::draw_strip.
  Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    return pipeline_.draw_strip(state_, strip, pixels);
  }
  /// See Renderer::draw_over.
  Status draw_over(const Rect& area, std::span<std::uint16_t> pixels, std::span<std::uint16_t> depth) {
    return pipeline_.draw_over(state_, area, pixels, depth);
  }
  /// Returns the frame that was begun last. It refers to this object.
  FrameOfSamples<FrameWithMethod> frame() const { return FrameOfSamples<FrameWithMethod>(state_); }
  /// Applies from the next begin_frame on; ignored without a method.
  void set_visibility(const VisibilityOptions& options) { state_.options = options; }

 private:
  Pipeline pipeline_;
  detail::MethodFrameState state_;
  bool takes_samples_;
};

}  // namespace zstrip
