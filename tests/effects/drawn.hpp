// Pictures of scenes with effects, by the one pipeline that they call for and by the host's supersets.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "zstrip/zstrip.hpp"

namespace effects_test {

using namespace zstrip;

/// RGB565, row by row, without gaps.
struct Drawn {
  int width = 0, height = 0;
  std::vector<std::uint16_t> pixels;

  std::uint16_t at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
  /// 0..252: the pixel's green, the channel with most bits.
  int green(int x, int y) const { return (at(x, y) >> 5 & 0x3F) << 2; }
  friend bool operator==(const Drawn&, const Drawn&) = default;
};

/// Strips of `plan` drawn by any renderer, put together.
template <class AnyKind>
Drawn drawn_by(AnyKind& renderer, const Scene& scene, const Camera& camera, const View& view, const Plan& plan) {
  std::vector<std::uint64_t> arena(plan.bytes() / 8 + 1, 0xA5A5A5A5A5A5A5A5ULL);
  const Status begun = renderer.begin_frame(scene, camera, view, plan, std::as_writable_bytes(std::span(arena)));
  EXPECT_TRUE(begun) << message(begun.error) << ' ' << begun.needed;
  Drawn drawn{view.width, view.height, {}};
  if (!begun) return drawn;
  drawn.pixels.resize(std::size_t{view.width} * view.height);
  std::vector<std::uint16_t> strip(std::size_t{plan.strip_rows} * plan.strip_columns, 0xDEAD);
  for (std::uint16_t s = 0; s < plan.strips; ++s) {
    EXPECT_TRUE(renderer.draw_strip(s, std::as_writable_bytes(std::span(strip))));
    const Rect area = plan.strip_area(s, view);
    for (int y = area.top; y < area.bottom; ++y) {
      for (int x = area.left; x < area.right; ++x) {
        drawn.pixels[static_cast<std::size_t>(y * view.width + x)] =
            strip[static_cast<std::size_t>((y - area.top) * area.width() + x - area.left)];
      }
    }
  }
  return drawn;
}

/// By the pipeline of exactly `effects`.
template <Effects effects>
Drawn draw(const Scene& scene, const Camera& camera, const View& view, const Budget& budget = {}) {
  EXPECT_TRUE(validate(scene));
  const PlanResult planned = plan(count(scene), view, effects, budget);
  EXPECT_TRUE(planned.status);
  Renderer<effects> renderer;
  return drawn_by(renderer, scene, camera, view, planned.plan);
}

/// By the host's pipeline for `effects`.
inline Drawn draw_any(Effects effects, const Scene& scene, const Camera& camera, const View& view,
                      const Budget& budget = {}) {
  const PlanResult planned = plan(count(scene), view, effects, budget);
  EXPECT_TRUE(planned.status);
  AnyRenderer renderer(effects);
  return drawn_by(renderer, scene, camera, view, planned.plan);
}

}  // namespace effects_test
