// The checks that a view with several samples adds; only renderers with effect::supersampled link it.
#include "zstrip/effects/samples/sample_stage.hpp"

namespace zstrip {

Status Frame::Access::Samples::check_view(const Camera& camera, const View& view) {
  if (!valid_samples(view)) return {.error = Error::samples, .needed = view.samples};
  if (samples_a_side(view) > kMaxViewSize) {
    return {.error = Error::view_size, .needed = samples_a_side(view), .available = kMaxViewSize};
  }
  if (sample_columns(view) != sample_rows(view) && camera.focal > detail::kLongestFocal) {
    return {.error = Error::camera};
  }
  return {};
}

Status Frame::Access::Samples::check_colour(const View& view, const Plan& plan) {
  const std::uint64_t needed = std::uint64_t{plan.strip_rows} * plan.strip_columns * view.samples * kWorkingColourBytes;
  return plan.colour_bytes < needed ? Checks::too_small(Purpose::colour, needed, plan.colour_bytes) : Status{};
}

Status Frame::Access::Samples::strip(const Frame& frame, std::uint16_t strip, std::span<const std::byte> pixels) {
  if (const Status status = Checks::strip_number(frame, strip); !status) return status;
  const Rect area = frame.plan_.strip_area(strip, frame.view_);
  return Checks::room(detail::pixels_of(area, frame.view_), frame.view_.format, pixels);
}

}  // namespace zstrip
