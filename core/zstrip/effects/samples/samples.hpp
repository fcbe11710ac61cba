// Converts between a view with several samples a pixel and the picture of samples that is drawn for it.
#pragma once

#include "zstrip/budget.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// Returns the view whose pixels are the samples. View::samples does not change.
constexpr View view_of_samples(View view) {
  view.width = static_cast<std::uint16_t>(view.width * sample_columns(view));
  view.height = static_cast<std::uint16_t>(view.height * sample_rows(view));
  return view;
}
constexpr View view_of_pixels(View samples) {
  samples.width = static_cast<std::uint16_t>(samples.width / sample_columns(samples));
  samples.height = static_cast<std::uint16_t>(samples.height / sample_rows(samples));
  return samples;
}

/// Returns the plan with the same strips in samples, of the same bytes. `view` may be that of either picture.
constexpr Plan plan_of_samples(Plan plan, const View& view) {
  plan.strip_columns = static_cast<std::uint16_t>(plan.strip_columns * sample_columns(view));
  plan.strip_rows = static_cast<std::uint16_t>(plan.strip_rows * sample_rows(view));
  return plan;
}
constexpr Plan plan_of_pixels(Plan samples, const View& view) {
  samples.strip_columns = static_cast<std::uint16_t>(samples.strip_columns / sample_columns(view));
  samples.strip_rows = static_cast<std::uint16_t>(samples.strip_rows / sample_rows(view));
  return samples;
}

/// Returns the pixels that have a sample in a rectangle of the picture of samples.
constexpr Rect pixels_of(const Rect& samples, const View& view) {
  const auto columns = static_cast<std::int32_t>(sample_columns(view));
  const auto rows = static_cast<std::int32_t>(sample_rows(view));
  return {samples.left / columns, samples.top / rows, (samples.right + columns - 1) / columns,
          (samples.bottom + rows - 1) / rows};
}

/// The longest focal length that camera_of_samples can double.
inline constexpr Fixed kMaxFocal = INT32_MAX / 2;

/// Returns the camera whose picture of samples has the view that `camera` has in the picture of pixels. A focal length
/// is relative to half of the height, so that two by two samples need no other camera; two samples side by side need
/// twice the focal length, and half of `up`.
constexpr Camera camera_of_samples(Camera camera, const View& view) {
  if (sample_columns(view) == sample_rows(view)) return camera;
  camera.focal *= 2;
  camera.up = {camera.up.x >> 1, camera.up.y >> 1, camera.up.z >> 1};
  return camera;
}

}  // namespace zstrip::detail
