// Hard cases C, of surfaces that are seen edge-on while planes cut them: snapping folds what is left of a triangle, so
// that part of it lies on the wrong side of an edge that it shares. Every pixel is still drawn once.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators.hpp"
#include "space.hpp"

namespace hard_cases {
namespace {

/// From 1 to 2^bits - 1, all magnitudes equally likely.
int any_magnitude(int bits) {
  const int top = between(0, bits - 1);
  return (1 << top) + between(0, (1 << top) - 1);
}

/// Samples that leave the position grid do not count: cut off there, they would not be edge-on.
std::int16_t coordinate(double value) {
  RC_PRE(std::abs(value) < 32767);
  return static_cast<std::int16_t>(std::lround(value));
}

/// Pixels that a triangle covers, and those that it would cover if it were turned over: with a fold in it some of both.
struct Sides {
  std::vector<bool> front, back;

  /// How often the outline winds around a pixel: so the numbers of neighbours add up to that of their union.
  int winding(std::size_t pixel) const { return front[pixel] - back[pixel]; }
};

Sides sides_of(Space& space, const Triangle& t) {
  const auto mask = [&space](const Triangle& triangle) {
    space.model.triangles = {triangle};
    const Picture picture = space.draw();
    RC_ASSERT(picture.status);
    const std::vector<bool> covered = mask_of(picture);
    // A fragment a pixel, whatever triangles it was cut into.
    RC_ASSERT(static_cast<std::ptrdiff_t>(picture.statistics.fragments) == std::ranges::count(covered, true));
    return covered;
  };
  Sides sides{mask(t), mask({t.a, t.c, t.b})};
  for (std::size_t i = 0; i < sides.front.size(); ++i) RC_ASSERT(!(sides.front[i] && sides.back[i]));
  return sides;
}

/// A cube of +-4 around the eye: positions are in 1/8192 units. Single-sided, so that either side can be looked at.
Space any_space() {
  Space space(4 * kFixedOne, 0);
  space.model.material.double_sided = false;
  if (between(0, 1) == 0) space.camera.projection = Projection::orthographic;
  space.camera.focal = 2 * kFixedOne + any_magnitude(20);
  space.camera.near_plane = any_magnitude(18);
  space.camera.far_plane = space.camera.near_plane + any_magnitude(18);
  return space;
}

/// A point that is seen `x` pixels to the right of the picture's middle and `y` below it, at `distance` in 1/8192
/// units.
Position seen_at(const Space& space, double x, double y, double distance) {
  const double across = space.camera.projection == Projection::orthographic ? 8192 : distance;
  const double unit = across / (kView.height / 2.0) * kFixedOne / space.camera.focal;
  return {coordinate(x * unit), coordinate(-y * unit), coordinate(-distance)};
}

RC_GTEST_PROP(HardCases, C29_HalvesOfAnEdgeOnQuadrilateralNeverOverlap, ()) {
  // Exactly flat: corners are lattice points of a plane that two whole vectors span, through the eye or parallel to the
  // line of sight; in half of the samples beside it by a little.
  Space space = any_space();
  const bool orthographic = space.camera.projection == Projection::orthographic;
  const bool beside = between(0, 1) == 0;
  const auto by_a_little = [beside] { return beside ? between(-2, 2) : 0; };
  const std::array<int, 3> across{between(-60, 60), between(-60, 60), between(-60, 60)};
  // Beyond the guard band: magnified around the picture's middle, which the plane then goes through.
  const bool beyond_guard_band = between(0, 3) == 0;
  const auto up_to = [beyond_guard_band](int limit) { return beyond_guard_band ? 0 : between(-limit, limit); };
  const int depth = between(30, 1000), tilt = between(-3, 3);
  const std::array<int, 3> away =
      orthographic ? std::array{tilt * across[0] + by_a_little(), tilt * across[1] + by_a_little(), -depth}
                   : std::array{up_to(depth / 2), up_to(depth / 2), -depth};
  const std::array<int, 3> origin =
      orthographic ? std::array{up_to(8000), up_to(4000), 0} : std::array{by_a_little(), by_a_little(), by_a_little()};
  if (beyond_guard_band) space.camera.focal = any_magnitude(31);
  std::array<std::array<int, 2>, 4> p;
  for (auto& corner : p) corner = {between(-200, 200), between(1, 32)};
  const auto turn = [&p](std::size_t i, std::size_t j, std::size_t k) {
    return (p[j][0] - p[i][0]) * (p[k][1] - p[i][1]) - (p[j][1] - p[i][1]) * (p[k][0] - p[i][0]);
  };
  // Around the outside: a, b, d, c. The diagonal b-c is shared.
  const std::array<int, 4> turns{turn(0, 1, 3), turn(1, 3, 2), turn(3, 2, 0), turn(2, 0, 1)};
  RC_PRE(*std::ranges::min_element(turns) > 0 || *std::ranges::max_element(turns) < 0);
  int nearest = INT16_MAX, farthest = 1;
  for (const auto& [i, j] : p) {
    const auto at = [&, i = i, j = j](std::size_t axis) { return origin[axis] + i * across[axis] + j * away[axis]; };
    space.model.positions.push_back({coordinate(at(0)), coordinate(at(1)), coordinate(at(2))});
    space.model.colours.push_back(kWhite);
    nearest = std::min(nearest, -at(2));
    farthest = std::max(farthest, -at(2));
  }
  // Planes that cut it: somewhere between its nearest and its farthest corner.
  nearest = std::max(nearest, 1);
  space.camera.near_plane = 8 * between(nearest, farthest);
  space.camera.far_plane = 8 * between(nearest, farthest + 4096);
  if (space.camera.far_plane < space.camera.near_plane) std::swap(space.camera.near_plane, space.camera.far_plane);
  ++space.camera.far_plane;

  const Sides first = sides_of(space, {0, 1, 2}), second = sides_of(space, {2, 1, 3});
  bool seen = false, folded = false;
  for (std::size_t i = 0; i < first.front.size(); ++i) {
    seen |= first.front[i] || second.front[i] || first.back[i] || second.back[i];
    folded |= (first.front[i] && second.back[i]) || (first.back[i] && second.front[i]);
    RC_ASSERT(!(first.front[i] && second.front[i]));
    RC_ASSERT(!(first.back[i] && second.back[i]));
  }
  RC_TAG(folded ? "one half folded over the other" : seen ? "seen" : "no pixel");
}

RC_GTEST_PROP(HardCases, C29_AClippedStepSeenEdgeOnLeavesNoHole, ()) {
  // Two treads joined by a riser that lies in the line of sight, all cut by near and far: together they look like one
  // wide band. Where the riser winds backwards the treads overlap, by exactly those pixels.
  Space space = any_space();
  // The step's upper edge, and behind it, as seen from the eye, the lower one.
  const double x0 = between(-900, 900) / 16.0, y0 = between(-600, 600) / 16.0;
  const double x1 = between(-900, 900) / 16.0, y1 = between(-600, 600) / 16.0;
  const int begin = between(1000, 20000), end = between(1000, 20000);
  const double behind = 1 + between(1, 600) / 1000.0;
  // To the left on the way from begin to end, and beyond the picture.
  const double length = std::hypot(x1 - x0, y1 - y0);
  RC_PRE(length > 0);
  const double left_x = 150 * (y1 - y0) / length, left_y = -150 * (x1 - x0) / length;
  space.model.positions = {seen_at(space, x0, y0, begin),
                           seen_at(space, x1, y1, end),
                           seen_at(space, x0, y0, begin * behind),
                           seen_at(space, x1, y1, end * behind),
                           seen_at(space, x0 + left_x, y0 + left_y, begin),
                           seen_at(space, x1 + left_x, y1 + left_y, end),
                           seen_at(space, x0 - left_x, y0 - left_y, begin * behind),
                           seen_at(space, x1 - left_x, y1 - left_y, end * behind)};
  space.model.colours.assign(8, kWhite);
  std::vector<Triangle> triangles{{0, 1, 5}, {0, 5, 4}, {2, 3, 1}, {2, 1, 0}, {6, 7, 3}, {6, 3, 2}};
  std::vector<int> winding(kPixels, 0), covered(kPixels, 0);
  for (const Triangle& t : triangles) {
    const Sides sides = sides_of(space, t);
    for (std::size_t i = 0; i < winding.size(); ++i) {
      winding[i] += sides.winding(i);
      covered[i] += sides.front[i];
    }
  }
  bool seen = false;
  for (std::size_t y = 1; y + 1 < 64; ++y) {
    for (std::size_t x = 1; x + 1 < 96; ++x) {
      const std::size_t i = y * 96 + x;
      seen |= winding[i] != 0;
      RC_ASSERT(winding[i] <= 0 || covered[i] > 0);
      const bool surrounded = winding[i - 1] > 0 && winding[i + 1] > 0 && winding[i - 96] > 0 && winding[i + 96] > 0;
      RC_ASSERT(!surrounded || winding[i] == 1);
    }
  }
  RC_TAG(seen ? "seen" : "no pixel");
}

}  // namespace
}  // namespace hard_cases
