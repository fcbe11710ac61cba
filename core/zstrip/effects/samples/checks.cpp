// The checks that a view with several samples adds; only renderers with effect::supersampled link it.
#include "zstrip/effects/samples/checks.hpp"

#include "zstrip/effects/samples/samples.hpp"
#include "zstrip/plan/record_bytes.hpp"
#include "zstrip/state/checks.hpp"

namespace zstrip::detail::samples {

Status check_view(const Camera& camera, const View& view) {
  if (!valid_samples(view)) return {.error = Error::samples, .needed = view.samples};
  if (samples_a_side(view) > kMaxViewSize) {
    return {.error = Error::view_size, .needed = samples_a_side(view), .available = kMaxViewSize};
  }
  if (sample_columns(view) != sample_rows(view) && camera.focal > kMaxFocal) {
    return {.error = Error::camera};
  }
  return {};
}

Status check_colour(const View& view, const Plan& plan) {
  const std::uint64_t needed = std::uint64_t{plan.strip_rows} * plan.strip_columns * view.samples * kWorkingColourBytes;
  return plan.colour_bytes < needed ? too_small(Purpose::colour, needed, plan.colour_bytes) : Status{};
}

}  // namespace zstrip::detail::samples

namespace zstrip::detail {

Status check_strip_of_samples(const FrameState& frame, std::uint16_t strip, std::span<const std::byte> pixels) {
  if (const Status status = check_strip_number(frame, strip); !status) return status;
  const Rect area = frame.plan.strip_area(strip, frame.view);
  return check_room(pixels_of(area, frame.view), frame.view.format, pixels);
}

}  // namespace zstrip::detail
