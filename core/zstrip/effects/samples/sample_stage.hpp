// The parts of effect::supersampled in the stages of a frame: first a picture of samples replaces the picture of
// pixels, and at the end the means of each strip's samples are pixels again.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/effects/samples/average.hpp"
#include "zstrip/effects/samples/checks.hpp"
#include "zstrip/effects/samples/samples.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::samples {

/// Begins a frame with several samples a pixel. Pixels are checked first, so that errors are in pixels. Then the
/// picture of samples is drawn. Its camera may have shortened axes, so that billboards use the camera of the picture.
template <Effects effects>
Status begin_frame(FrameState& frame, const FrameRequest& request, std::span<std::byte> arena) {
  const View& view = request.view;
  if (const Status status = check_view(request.camera, view); !status) return status;
  if (const Status status = check_frame<effects>(request, arena); !status) return status;
  if (const Status status = check_colour(view, request.plan); !status) return status;
  const Camera camera = camera_of_samples(request.camera, view);
  const View samples = view_of_samples(view);
  const Plan plan = plan_of_samples(request.plan, view);
  const FrameRequest drawing{request.scene, camera, samples, plan, request.counts, request.called_for};
  if (const Status status = check_frame<effects>(drawing, arena); !status) return status;
  const Status status = begin_checked_frame<effects>(frame, drawing, request.camera, arena);
  frame.has_special_depth = true;
  return status;
}

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::supersampled;

  template <Effects effects>
  static bool needs_working_strip(const FrameState& frame) {
    return frame.view.samples != 1;
  }
  template <Effects effects>
  static Status check_over(const FrameState& frame) {
    return frame.view.samples == 1 ? Status{} : Status{.error = Error::samples, .needed = frame.view.samples};
  }
  /// Writes the means over the samples, or directly into the caller's pixels.
  template <Effects effects>
  static void resolve(const FrameState& frame, const StripTarget&, StripImage& image) {
    const View& view = frame.view;
    if (view.samples == 1) return;
    const std::uint16_t* const samples = image.pixels;
    image.area = pixels_of(image.area, view);
    if (drawn_in_place(view.format)) image.pixels = reinterpret_cast<std::uint16_t*>(image.out);
    average<effects>(view, image.area, samples, image.pixels);
  }

 private:
  template <Effects effects>
  static void average(const View& view, const Rect& pixels, const std::uint16_t* samples, std::uint16_t* mean) {
    if constexpr (effects.has(effect::dithered_colours)) {
      if (dithers_colours(view)) return average_samples<true>(view, pixels, samples, mean);
    }
    average_samples<false>(view, pixels, samples, mean);
  }
};

}  // namespace zstrip::detail::samples
