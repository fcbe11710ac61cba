// Lines and points against docs/conventions.md: covered pixels, depth and clipping.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "line_world.hpp"

namespace lines_test {
namespace {

/// Exact integers: 1/16 pixels times the length of the line along its longer axis.
struct IntegerOracle {
  struct Place {
    std::int64_t x, y, z;  ///< 1/16 pixels of the picture, y downwards
  };
  static Place place(const Position& p) { return {p.x + 8 * kView.width, 8 * kView.height - p.y, p.z}; }

  /// The line's share from a to b at the pixel (0 for a point); empty where it is not covered.
  static std::optional<Real> share_at(const Position& from, const Position& to, bool is_point, int width, int x,
                                      int y) {
    Place a = place(from), b = place(to);
    std::int64_t along = 16 * x + 8, across = 16 * y + 8;
    const auto around = [width](std::int64_t centre, std::int64_t place, std::int64_t scale) {
      return place - 8 * width * scale < centre * scale && centre * scale <= place + 8 * width * scale;
    };
    if (is_point) return around(along, a.x, 1) && around(across, a.y, 1) ? std::optional<Real>(0) : std::nullopt;
    if (std::abs(b.x - a.x) < std::abs(b.y - a.y)) {
      std::swap(a.x, a.y);
      std::swap(b.x, b.y);
      std::swap(along, across);
    }
    const std::int64_t low = std::min(a.x, b.x), high = std::max(a.x, b.x);
    // The pixel's own 16 sub-pixels and the line have one in common.
    if (along + 8 <= low || along - 8 > high) return std::nullopt;
    const std::int64_t nearest = std::clamp(along, low, high);
    if (a.x == b.x) return around(across, a.y, 1) ? std::optional<Real>(0) : std::nullopt;
    const std::int64_t sign = b.x > a.x ? 1 : -1, length = sign * (b.x - a.x), gone = sign * (nearest - a.x);
    if (!around(across, a.y * length + (b.y - a.y) * gone, length)) return std::nullopt;
    return static_cast<Real>(gone) / static_cast<Real>(length);
  }
};

Real orthographic_code(const Camera& camera, Real z) {
  const Real near = camera.near_plane / 65536.0L * (1 - 1.0L / (1 << 20));
  const Real far = camera.far_plane / 65536.0L * (1 + 1.0L / (1 << 20));
  const Real w = camera.eye.z / 65536.0L - z / 32768 * 4;
  return 1 + 65533 * (far - w) / (far - near);
}

/// Compares every pixel of one segment.
int judge(World& world, const DepthPicture& picture) {
  int covered = 0;
  const Segment segment = world.segments.front();
  const Position a = world.positions[segment.a], b = world.positions[segment.b];
  for (int y = 0; y < kView.height; ++y) {
    for (int x = 0; x < kView.width; ++x) {
      const auto share = IntegerOracle::share_at(a, b, segment.a == segment.b, world.lines.width, x, y);
      const std::uint32_t code = code_at(picture, x, y);
      EXPECT_EQ(code != 0, share.has_value()) << x << ',' << y << " of " << a.x << ',' << a.y << " - " << b.x << ','
                                              << b.y << " width " << int{world.lines.width};
      if (!share) continue;
      ++covered;
      const Real exact = orthographic_code(world.camera, a.z + *share * (b.z - a.z));
      EXPECT_NEAR(static_cast<double>(code), static_cast<double>(exact), 0.75) << x << ',' << y;
    }
  }
  return covered;
}

TEST(Lines, CoverExactlyThePixelsAroundTheSegment) {
  std::mt19937 random(1);
  int covered = 0;
  for (int i = 0; i < 1500 && !HasFailure(); ++i) {
    World world = World::in_pixels();
    // Inside the picture, tiny, beyond its borders, and as far as vertices go.
    const int reach = std::array{700, 40, 2500, 32767}[static_cast<std::size_t>(i & 3)];
    const Position a = any_position(random, reach, reach);
    Position b = any_position(random, reach, reach);
    if (i % 7 == 0) b.x = a.x;
    if (i % 11 == 0) b.y = a.y;
    if (i % 13 == 0) b.y = static_cast<std::int16_t>(std::clamp(a.y + (b.x - a.x), -32767, 32767));
    world.line(a, b);
    world.lines.width = static_cast<std::uint8_t>(i % 5 == 0 ? 1 + random() % 64 : 1 + random() % 4);
    covered += judge(world, world.draw());
  }
  EXPECT_GT(covered, 100000);
}

TEST(Lines, OfPointsAreSquares) {
  std::mt19937 random(2);
  int covered = 0;
  for (int i = 0; i < 400 && !HasFailure(); ++i) {
    World world = World::in_pixels();
    world.point(any_position(random, 900, 700));
    world.lines.width = static_cast<std::uint8_t>(1 + random() % (i % 4 == 0 ? 64 : 6));
    covered += judge(world, world.draw());
  }
  EXPECT_GT(covered, 5000);
}

TEST(Lines, AreTheSameInBothDirections) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    World world = World::in_pixels();
    world.line(any_position(random, 1500, 1000), any_position(random, 1500, 1000));
    const DepthPicture there = world.draw();
    std::swap(world.segments[0].a, world.segments[0].b);
    ASSERT_EQ(world.draw().depth, there.depth) << i;
  }
}

TEST(Lines, OfAPolylineLeaveNoGap) {
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    World world = World::in_pixels();
    const std::uint16_t corners = 12;
    for (std::uint16_t corner = 0; corner < corners; ++corner) {
      world.positions.push_back(any_position(random, i % 2 == 0 ? 700 : 60, i % 2 == 0 ? 500 : 60));
      world.segments.push_back({corner, static_cast<std::uint16_t>((corner + 1) % corners)});
    }
    const DepthPicture picture = world.draw();
    // From any of its pixels all others are reached by steps to one of the eight around.
    std::vector<bool> seen(picture.depth.size());
    std::vector<int> open;
    std::size_t drawn = 0, reached = 0;
    for (std::size_t at = 0; at < picture.depth.size(); ++at) {
      if (picture.depth[at] == 0) continue;
      if (drawn++ == 0) open.push_back(static_cast<int>(at)), seen[at] = true;
    }
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      ++reached;
      for (int y = std::max(at / kView.width - 1, 0); y <= std::min(at / kView.width + 1, kView.height - 1); ++y) {
        for (int x = std::max(at % kView.width - 1, 0); x <= std::min(at % kView.width + 1, kView.width - 1); ++x) {
          const auto next = static_cast<std::size_t>(y * kView.width + x);
          if (picture.depth[next] != 0 && !seen[next]) open.push_back(static_cast<int>(next)), seen[next] = true;
        }
      }
    }
    ASSERT_GT(drawn, 5U);
    ASSERT_EQ(reached, drawn) << i;
  }
}

/// docs/conventions.md, "Depth formats", over the camera's range.
Real exact_code(DepthFormat format, const Camera& camera, Real w) {
  const Real n = camera.near_plane / 65536.0L * (1 - 1.0L / (1 << 20));
  const Real f = camera.far_plane / 65536.0L * (1 + 1.0L / (1 << 20));
  const bool orthographic = camera.projection == Projection::orthographic;
  const Real share = orthographic ? (f - w) / (f - n) : (1 / w - 1 / f) / (1 / n - 1 / f);
  switch (format) {
    case DepthFormat::z16: return 1 + 65533 * share;
    case DepthFormat::z24: return 1 + (16777216.0L - 3) * share;
    case DepthFormat::float16: break;
  }
  const Real v = (4294967296.0L - 393216) * n / w;
  if (v < 33554432) return std::max(v / 4096, Real{1});
  const int exponent = std::ilogb(v) - 24;
  return exponent * 8192 + (v / std::exp2(Real(11 + exponent)) - 8192);
}

struct Seen {
  Real x, y, w;
};

/// Ends in the picture, in pixels, between near and far; empty if nothing is.
std::optional<std::array<Seen, 2>> seen_ends(const World& world, const Position& from, const Position& to) {
  struct V {
    Real x, y, w;
  };
  const auto view = [&](const Position& p) {
    const auto scaled = [](std::int16_t c, Fixed half) { return c / 32768.0L * half / 65536.0L; };
    const Vec3& half = world.mesh.half_extent;
    return V{scaled(p.x, half.x), scaled(p.y, half.y), world.camera.eye.z / 65536.0L - scaled(p.z, half.z)};
  };
  V a = view(from), b = view(to);
  const auto cut = [](V& outer, const V& inner, Real plane) {
    const Real t = (plane - inner.w) / (outer.w - inner.w);
    outer = {inner.x + t * (outer.x - inner.x), inner.y + t * (outer.y - inner.y), plane};
  };
  const Real near = world.camera.near_plane / 65536.0L, far = world.camera.far_plane / 65536.0L;
  if (std::max(a.w, b.w) <= near || std::min(a.w, b.w) >= far) return std::nullopt;
  if (a.w < near) cut(a, b, near);
  if (b.w < near) cut(b, a, near);
  if (a.w > far) cut(a, b, far);
  if (b.w > far) cut(b, a, far);
  const auto project = [&](const V& v) {
    const Real scale = world.camera.focal / 65536.0L * kView.height / 2 /
                       (world.camera.projection == Projection::orthographic ? 1 : v.w);
    return Seen{kView.width / 2 + v.x * scale, kView.height / 2 - v.y * scale, v.w};
  };
  return std::array{project(a), project(b)};
}

class LinesIn : public testing::TestWithParam<DepthFormat> {};

TEST_P(LinesIn, PerspectiveAreClippedAndDeepAsTheLineIs) {
  const DepthFormat format = GetParam();
  std::mt19937 random(5);
  int covered = 0, clipped = 0;
  constexpr Real kSlack = 1.1L;
  Real worst = 0;
  for (int i = 0; i < 400 && !HasFailure(); ++i) {
    World world;
    world.mesh.half_extent = {fixed(8.0), fixed(8.0), fixed(16.0)};
    world.line(any_position(random, 32767, 32767), any_position(random, 32767, 32767));
    world.lines.width = static_cast<std::uint8_t>(1 + random() % 3);
    const Position &from = world.positions[0], &to = world.positions[1];
    const DepthPicture picture = world.draw(depth_effect(format));
    const auto ends = seen_ends(world, from, to);
    if (ends) clipped += (*ends)[0].w <= 1.0L || (*ends)[1].w <= 1.0L ? 1 : 0;
    for (int y = 0; y < kView.height; ++y) {
      for (int x = 0; x < kView.width; ++x) {
        const std::uint32_t code = code_at(picture, x, y);
        if (!ends) {
          EXPECT_EQ(code, 0U);
          continue;
        }
        Seen a = (*ends)[0], b = (*ends)[1];
        Real along = x + 0.5L, across = y + 0.5L;
        const Real length_x = std::abs(b.x - a.x), length_y = std::abs(b.y - a.y);
        constexpr Real kSnap = 0.13L;
        if (std::abs(length_x - length_y) < 2 * kSnap) continue;
        if (length_x < length_y) std::swap(a.x, a.y), std::swap(b.x, b.y), std::swap(along, across);
        if (a.x > b.x) std::swap(a, b);
        const Real t = std::clamp((along - a.x) / (b.x - a.x), Real{0}, Real{1});
        const Real off = std::abs(across - (a.y + t * (b.y - a.y))) - world.lines.width / Real{2};
        const Real beyond = std::max(a.x - along, along - b.x);
        if (off < -kSnap && beyond < 0.5L - kSnap) {
          EXPECT_NE(code, 0U) << x << ',' << y << " line " << i;
        }
        if (off > kSnap || beyond > 0.5L + kSnap) {
          EXPECT_EQ(code, 0U) << x << ',' << y << " line " << i;
        }
        if (code == 0 || b.x - a.x < 1) continue;
        ++covered;
        const auto code_of = [&](Real share) {
          share = std::clamp(share, Real{0}, Real{1});
          return exact_code(format, world.camera, 1 / (1 / a.w + share * (1 / b.w - 1 / a.w)));
        };
        const Real shift = kSnap / (b.x - a.x);
        const Real error = std::abs(code - code_of(t)) - std::abs(code_of(t - shift) - code_of(t + shift));
        worst = std::max(worst, error);
        EXPECT_LT(static_cast<double>(error), static_cast<double>(kSlack)) << x << ',' << y << " line " << i;
      }
    }
  }
  EXPECT_GT(covered, 4000);
  EXPECT_GT(clipped, 60);
  RecordProperty("worst", std::to_string(static_cast<double>(worst)));
}
INSTANTIATE_TEST_SUITE_P(EveryDepthFormat, LinesIn,
                         testing::Values(DepthFormat::z16, DepthFormat::float16, DepthFormat::z24));

}  // namespace
}  // namespace lines_test
