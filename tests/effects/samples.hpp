// Pictures with several samples a pixel, in any format, put together of strips.
#pragma once

#include <algorithm>
#include <cstddef>

#include "drawn.hpp"

namespace effects_test {

inline constexpr View kPixels{75, 58, PixelFormat::rgb565};

constexpr View with_samples(const View& view, int samples, PixelFormat format = PixelFormat::rgb565,
                            bool dither = false) {
  return {view.width, view.height, format, dither, static_cast<std::uint8_t>(samples)};
}

/// The whole picture's bytes, put together of strips.
template <class AnyKind>
std::vector<std::uint8_t> bytes_by(AnyKind& renderer, const Scene& scene, const Camera& camera, const View& view,
                                   const Plan& plan) {
  const picture::Picture picture = picture::draw(renderer, scene, camera, view, plan);
  EXPECT_TRUE(picture.status) << message(picture.status.error) << ' ' << picture.status.needed;
  std::vector<std::uint8_t> bytes(picture.pixels.size());
  std::ranges::transform(picture.pixels, bytes.begin(), std::to_integer<std::uint8_t>);
  return bytes;
}

inline std::vector<std::uint8_t> bytes_of(Effects effects, const Scene& scene, const Camera& camera, const View& view,
                                          const Budget& budget = {}) {
  const PlanResult planned = plan(count(scene), view, effects, budget);
  EXPECT_TRUE(planned.status) << message(planned.status.error);
  AnyRenderer renderer(effects);
  return bytes_by(renderer, scene, camera, view, planned.plan);
}

}  // namespace effects_test
