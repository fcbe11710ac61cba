// Pictures of scenes with effects, by the one pipeline that they call for and by the host's supersets.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "../oracle/draw.hpp"
#include "zstrip/zstrip.hpp"

namespace effects_test {

using namespace zstrip;
using picture::begun;
using picture::lent;

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
  const picture::Picture picture = picture::draw(renderer, scene, camera, view, plan);
  EXPECT_TRUE(picture.status) << message(picture.status.error) << ' ' << picture.status.needed;
  return {view.width, view.height, rgb565_of(picture)};
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
