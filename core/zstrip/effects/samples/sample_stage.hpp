// What effect::supersampled adds to the stages of a frame: before them a picture of samples takes the place of the
// pixels', after them the means of its strips are pixels again.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/effects/dithering/dither.hpp"
#include "zstrip/effects/samples/average.hpp"
#include "zstrip/effects/samples/samples.hpp"
#include "zstrip/frame/checks.hpp"
#include "zstrip/resolve/convert.hpp"

namespace zstrip {

struct Frame::Access::Samples {
  /// Of a view with several samples. All checks of pixels come first, so that errors count pixels.
  template <Effects effects>
  static Status begin_frame(Frame& frame, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                            std::span<std::byte> arena) {
    abandon(frame);
    if (const Status status = check_view(camera, view); !status) return status;
    if (const Status status = Checks::frame<effects>(scene, camera, view, plan, effects_of(scene, camera), arena);
        !status) {
      return status;
    }
    if (const Status status = check_colour(view, plan); !status) return status;
    const Status status = begin<effects>(frame, scene, camera, view, plan, arena);
    frame.has_special_depth_ = true;
    return status;
  }

  /// Of draw_strip.
  static Status strip(const Frame& frame, std::uint16_t strip, std::span<const std::byte> pixels);

  /// `area` of the picture of samples, which are in `samples`.
  template <Effects effects>
  static void resolve(const Frame& frame, const Rect& area, std::uint16_t* samples, std::byte* out) {
    const View& view = frame.view_;
    const Rect pixels = detail::pixels_of(area, view);
    std::uint16_t* const mean = detail::drawn_in_place(view.format) ? reinterpret_cast<std::uint16_t*>(out) : samples;
    average<effects>(view, pixels, samples, mean);
    if constexpr (effects.has(effect::dithered_format)) {
      if (view.dither) dither_pixels(view.format, pixels, mean);
    }
    convert_pixels(view.format, static_cast<std::uint16_t>(pixels.width()), static_cast<std::uint16_t>(pixels.height()),
                   mean, out);
  }

 private:
  /// The picture of samples. Its camera's axes may be halves: billboards turn to the picture's own.
  template <Effects effects>
  static Status begin(Frame& frame, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                      std::span<std::byte> arena) {
    const Camera drawing = detail::camera_of_samples(camera, view);
    const View samples = detail::view_of_samples(view);
    const Plan strips = detail::plan_of_samples(plan, view);
    if constexpr (effects.has(effect::billboards)) {
      return Access::begin_facing<effects>(frame, scene, drawing, camera, samples, strips, arena);
    } else {
      return Access::begin_frame<effects>(frame, scene, drawing, samples, strips, arena);
    }
  }

  static Status check_view(const Camera& camera, const View& view);
  /// A plan for pixels of RGB565 has no working strip.
  static Status check_colour(const View& view, const Plan& plan);

  template <Effects effects>
  static void average(const View& view, const Rect& pixels, const std::uint16_t* samples, std::uint16_t* mean) {
    if constexpr (effects.has(effect::dithered_colours)) {
      if (dithers_colours(view)) return detail::average_samples<true>(view, pixels, samples, mean);
    }
    detail::average_samples<false>(view, pixels, samples, mean);
  }
};

}  // namespace zstrip
