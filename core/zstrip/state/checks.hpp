// Checks the caller's requests before any stage runs, so that no stage accesses memory out of bounds. These checks do
// not depend on effects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail {

/// Checks a request of begin_frame, for a renderer with `effects`. validate() has already checked the index arrays.
Status check_request(const Scene& scene, const SceneCounts& counts, const Camera& camera, const View& view,
                     const Plan& plan, Effects called_for, Effects effects, std::span<std::byte> arena);
Status check_strip(const FrameState& frame, std::uint16_t strip, std::span<const std::byte> pixels);
/// Checks a request of draw_strip if the frame is one of samples and `pixels` are pixels of the display.
Status check_strip_of_samples(const FrameState& frame, std::uint16_t strip, std::span<const std::byte> pixels);
inline Status check_strip_number(const FrameState& frame, std::uint16_t strip) {
  if (frame.scene == nullptr) return {.error = Error::not_begun};
  if (strip >= frame.plan.strips) {
    return {.error = Error::strip_rows, .needed = strip, .available = frame.plan.strips};
  }
  return {};
}
inline Status check_room(const Rect& area, PixelFormat format, std::span<const std::byte> pixels) {
  const auto rows = static_cast<std::uint32_t>(area.height());
  const std::uint32_t needed = rows * bytes_per_row(static_cast<std::uint16_t>(area.width()), format);
  if (pixels.size() < needed) {
    const auto available = static_cast<std::uint32_t>(pixels.size());
    return {.error = Error::pixels_too_small, .needed = needed, .available = available};
  }
  if (drawn_in_place(format) && reinterpret_cast<std::uintptr_t>(pixels.data()) % 2 != 0) {
    return {.error = Error::pixels_misaligned};
  }
  return {};
}

/// Checks a request of draw_over: `area` must lie in the picture, and there must be enough pixels and depths.
Status check_area(const FrameState& frame, const Rect& area, std::size_t pixels, std::size_t depths);
}  // namespace zstrip::detail
