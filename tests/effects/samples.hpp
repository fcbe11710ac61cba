// Pictures with several samples a pixel, in any format, put together of strips.
#pragma once

#include <cstring>

#include "drawn.hpp"

namespace effects_test {

inline constexpr View kPixels{75, 58, PixelFormat::rgb565};

constexpr View with_samples(const View& view, int samples, PixelFormat format = PixelFormat::rgb565,
                            bool dither = false) {
  return {view.width, view.height, format, dither, static_cast<std::uint8_t>(samples)};
}

/// The whole picture's bytes, put together of strips. Everything that is lent has exactly the planned size.
template <class AnyKind>
std::vector<std::uint8_t> bytes_by(AnyKind& renderer, const Scene& scene, const Camera& camera, const View& view,
                                   const Plan& plan) {
  std::vector<std::uint64_t> arena(plan.bytes() / 8, 0xA5A5A5A5A5A5A5A5ULL);
  const Status begun = renderer.begin_frame(scene, camera, view, plan, std::as_writable_bytes(std::span(arena)));
  EXPECT_TRUE(begun) << message(begun.error) << ' ' << begun.needed;
  if (!begun) return {};
  const std::size_t row_bytes = bytes_per_row(view.width, view.format);
  std::vector<std::uint8_t> picture(row_bytes * view.height);
  std::vector<std::uint16_t> strip((plan.strip_pixel_bytes(view) + 1) / 2, 0xDEAD);
  for (std::uint16_t s = 0; s < plan.strips; ++s) {
    const auto bytes = std::as_writable_bytes(std::span(strip)).first(plan.strip_pixel_bytes(view));
    EXPECT_TRUE(renderer.draw_strip(s, bytes));
    const Rect area = plan.strip_area(s, view);
    const std::size_t length = bytes_per_row(static_cast<std::uint16_t>(area.width()), view.format);
    const std::size_t left = bytes_per_row(static_cast<std::uint16_t>(area.left), view.format);
    for (int y = area.top; y < area.bottom; ++y) {
      std::memcpy(picture.data() + static_cast<std::size_t>(y) * row_bytes + left,
                  bytes.data() + static_cast<std::size_t>(y - area.top) * length, length);
    }
  }
  return picture;
}

inline std::vector<std::uint8_t> bytes_of(Effects effects, const Scene& scene, const Camera& camera, const View& view,
                                          const Budget& budget = {}) {
  const PlanResult planned = plan(count(scene), view, effects, budget);
  EXPECT_TRUE(planned.status) << message(planned.status.error);
  AnyRenderer renderer(effects);
  return bytes_by(renderer, scene, camera, view, planned.plan);
}

}  // namespace effects_test
