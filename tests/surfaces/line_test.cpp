// Lines and points against docs/conventions.md: covered pixels and depth, clipping, order, bounds, what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "depth_picture.hpp"
#include "drawn.hpp"
#include "zstrip/base/crc32.hpp"

namespace {

using namespace zstrip;
using picture::DepthPicture;
using picture::DepthRenderer;
using Real = long double;

constexpr View kView{96, 64};

/// Vertices in a box, and what is drawn of them.
struct World {
  std::vector<Position> positions;
  std::vector<Colour> colours;
  std::vector<Segment> segments;
  Mesh mesh;
  Material material{.colour = {255, 255, 255, 255}, .lit = false};
  LineSet lines;
  Camera camera;

  World() {
    camera.eye = {0, 0, fixed(8.0)};
    camera.near_plane = fixed(1.0);
    camera.far_plane = fixed(20.0);
    camera.fixed_depth_range = true;
  }
  /// Coordinates are 1/16 pixels from the middle of kView, y upwards; z up to 4 units around the origin.
  static World in_pixels() {
    World world;
    world.camera.projection = Projection::orthographic;
    world.camera.focal = kFixedOne / 32;  // half of 64 rows
    world.mesh.half_extent = {fixed(2048.0), fixed(2048.0), fixed(4.0)};
    return world;
  }
  Scene scene() {
    mesh.positions = positions;
    mesh.colours = colours;
    lines.segments = segments;
    Scene s;
    s.meshes = {&mesh, 1};
    s.materials = {&material, 1};
    s.lines = {&lines, 1};
    return s;
  }
  void line(const Position& a, const Position& b) {
    const auto first = static_cast<std::uint16_t>(positions.size());
    positions.push_back(a);
    positions.push_back(b);
    segments.push_back({first, static_cast<std::uint16_t>(first + 1)});
  }
  void point(const Position& p) {
    positions.push_back(p);
    const auto last = static_cast<std::uint16_t>(positions.size() - 1);
    segments.push_back({last, last});
  }
  void clear() {
    positions.clear();
    segments.clear();
  }
  DepthPicture draw(Effects more = {}, std::uint16_t rows = kView.height) {
    EXPECT_TRUE(validate(scene()));
    return DepthRenderer(effects_of(scene(), camera) | effect::statistics | more, kView, rows).draw(scene(), camera);
  }
};

std::uint32_t code_at(const DepthPicture& picture, int x, int y) {
  return picture.depth[static_cast<std::size_t>(y * kView.width + x)];
}

Position any_position(std::mt19937& random, int reach_x, int reach_y) {
  const auto any = [&random](int reach) {
    return static_cast<std::int16_t>(static_cast<int>(random() % static_cast<unsigned>(2 * reach + 1)) - reach);
  };
  return {any(reach_x), any(reach_y), any(32767)};
}

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
    case DepthFormat::z32: return 16 + (4294967296.0L - 32) * share;
    case DepthFormat::w16: return 65534 - 65533 * (w - n) / (f - n);
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
  const Real slack = format == DepthFormat::z32 ? 600 : format == DepthFormat::z24 ? 4 : 1.1L;
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
        EXPECT_LT(static_cast<double>(error), static_cast<double>(slack)) << x << ',' << y << " line " << i;
      }
    }
  }
  EXPECT_GT(covered, 4000);
  EXPECT_GT(clipped, 60);
  RecordProperty("worst", std::to_string(static_cast<double>(worst)));
}
INSTANTIATE_TEST_SUITE_P(EveryDepthFormat, LinesIn,
                         testing::Values(DepthFormat::z16, DepthFormat::float16, DepthFormat::w16, DepthFormat::z24,
                                         DepthFormat::z32));

/// Lines of all kinds, some of them behind the eye.
World tangle(Projection projection) {
  World world;
  std::mt19937 random(6);
  world.mesh.half_extent = {fixed(8.0), fixed(6.0), fixed(16.0)};
  world.camera.projection = projection;
  if (projection == Projection::orthographic) world.camera.focal = fixed(0.15);
  for (int i = 0; i < 60; ++i) {
    if (i % 5 == 0) {
      world.point(any_position(random, 12000, 12000));
    } else {
      world.line(any_position(random, 32767, 32767), any_position(random, 32767, 32767));
    }
  }
  for (std::size_t i = 0; i < world.positions.size(); ++i) {
    world.colours.push_back({static_cast<std::uint8_t>(50 + 2 * i), static_cast<std::uint8_t>(random()), 90, 255});
  }
  world.lines.width = 3;
  return world;
}

TEST(Lines, HaveTheirChecksums) {
  for (const auto& [projection, checksum] :
       {std::pair{Projection::perspective, 0x5620BD75U}, std::pair{Projection::orthographic, 0xC84877FEU}}) {
    World world = tangle(projection);
    const Scene scene = world.scene();
    const effects_test::Drawn drawn =
        effects_test::draw_any(effects_of(scene, world.camera), scene, world.camera, kView);
    EXPECT_EQ(crc32(std::as_bytes(std::span(drawn.pixels))), checksum);
  }
}

TEST(Lines, StripsTilesBinsAndMethodsDrawTheSame) {
  using effects_test::draw_any;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    World world = tangle(projection);
    const Scene scene = world.scene();
    const Effects effects = effects_of(scene, world.camera);
    const effects_test::Drawn whole = draw_any(effects, scene, world.camera, kView);
    EXPECT_GT(std::ranges::count_if(whole.pixels, [](std::uint16_t pixel) { return pixel != 0; }), 1500);
    const effects_test::Drawn exact =
        projection == Projection::perspective
            ? effects_test::draw<effect::lines>(scene, world.camera, kView)
            : effects_test::draw<effect::lines | effect::orthographic>(scene, world.camera, kView);
    EXPECT_EQ(exact, whole) << "the superset's";
    for (const Budget& budget : {Budget{.strip_rows = 1}, Budget{.strip_rows = 7, .strip_columns = 24},
                                 Budget{.strip_rows = 16, .modes = Modes::binned}}) {
      EXPECT_EQ(draw_any(effects | effect::bins, scene, world.camera, kView, budget), whole)
          << budget.strip_rows << 'x' << budget.strip_columns;
    }
    EXPECT_EQ(draw_any(effects | effect::depth_ranges, scene, world.camera, kView, {.strip_rows = 8}), whole);
    for (const Effects method : {method::hierarchical_z, method::front_to_back, method::midpoint_safe}) {
      EXPECT_EQ(draw_any(effects | method, scene, world.camera, kView, {.strip_rows = 16}), whole) << method.methods;
    }
  }
}

/// Vertices, sizes, transforms and cameras at the ends of their ranges: nothing overflows, and strips agree.
TEST(Lines, AtTheEndsOfAllRangesStripsAgree) {
  std::mt19937 random(7);
  int drawn = 0;
  for (int i = 0; i < 300; ++i) {
    World world;
    const Fixed sizes[] = {1, 6554, kFixedOne, fixed(4095.0)};
    const auto size = [&] { return sizes[random() % 4]; };
    world.mesh.half_extent = {size(), size(), size()};
    const Fixed scales[] = {1, kFixedOne, (Fixed{1} << 24) - 1, -((Fixed{1} << 24) - 1)};
    for (auto& row : world.lines.transform.m) {
      for (int column = 0; column < 3; ++column) row[column] = random() % 2 == 0 ? 0 : scales[random() % 4];
    }
    world.camera.near_plane = random() % 2 == 0 ? 1 : 6554;
    world.camera.far_plane = random() % 2 == 0 ? INT32_MAX : fixed(100.0);
    world.camera.focal = random() % 2 == 0 ? fixed(1.7) : fixed(30.0);
    world.camera.fixed_depth_range = random() % 2 == 0;
    if (random() % 3 == 0) world.camera.projection = Projection::orthographic;
    const std::int16_t ends[] = {-32768, 32767, 0, 1, 20000};
    const auto any = [&] { return ends[random() % 5]; };
    for (int k = 0; k < 30; ++k) {
      const Position a{any(), any(), any()}, b{any(), any(), any()};
      if (k % 4 == 0) {
        world.point(a);
      } else {
        world.line(a, b);
      }
    }
    world.lines.width = static_cast<std::uint8_t>(random() % 2 == 0 ? 64 : 1);
    const Scene scene = world.scene();
    ASSERT_TRUE(validate(scene));
    const Effects effects = effects_of(scene, world.camera) | effect::statistics;
    const DepthPicture whole = DepthRenderer(effects, kView, kView.height).draw(scene, world.camera);
    if (!whole.status) {
      EXPECT_EQ(whole.status.error, Error::lines);
      continue;
    }
    drawn += std::ranges::any_of(whole.depth, [](std::uint32_t code) { return code != 0; }) ? 1 : 0;
    const DepthPicture parts = DepthRenderer(effects, kView, 5).draw(scene, world.camera);
    ASSERT_EQ(parts.depth, whole.depth) << i;
    ASSERT_EQ(parts.pixels, whole.pixels) << i;
  }
  EXPECT_GT(drawn, 60);
}

/// A wall of two triangles at z = 0 before and behind which lines pass.
struct Wall {
  Position corners[4] = {{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
  Triangle triangles[2] = {{0, 1, 2}, {0, 2, 3}};
  Segment edges[5] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}};
  Mesh mesh{
      .positions = corners, .normals = {}, .colours = {}, .texcoords = {}, .triangles = triangles, .meshlets = {}};
  Material materials[2] = {{.colour = {0, 0, 255, 255}, .lit = false}, {.colour = {255, 0, 0, 255}, .lit = false}};
  Instance instance{};
  LineSet lines{.segments = edges, .material = 1};
  Camera camera{};

  Wall() {
    camera.eye = {fixed(1.0), fixed(1.5), fixed(4.0)};
    camera.near_plane = fixed(1.0);
    camera.far_plane = fixed(20.0);
  }
  Scene scene() {
    Scene s;
    s.meshes = {&mesh, 1};
    s.materials = materials;
    s.instances = {&instance, 1};
    s.lines = {&lines, 1};
    return s;
  }
  int red_pixels() {
    const Scene s = scene();
    const effects_test::Drawn drawn = effects_test::draw_any(effects_of(s, camera), s, camera, kView);
    return static_cast<int>(std::ranges::count(drawn.pixels, 0xF800));
  }
};

TEST(Lines, AreHiddenByWhatIsNearer) {
  Wall wall;
  ASSERT_TRUE(look_at(wall.camera, wall.camera.eye, {0, 0, 0}, {0, kFixedOne, 0}));
  wall.instance.transform.m[2][3] = fixed(-1.0);  // the wall is behind its lines
  const int all = wall.red_pixels();
  EXPECT_GT(all, 100);
  wall.instance.transform.m[2][3] = fixed(0.5);  // before
  wall.lines.transform.m[0][0] = wall.lines.transform.m[1][1] = fixed(0.5);
  EXPECT_EQ(wall.red_pixels(), 0);
}

TEST(Lines, WithABiasLieInFrontOfTheirOwnSurface) {
  Wall wall;
  ASSERT_TRUE(look_at(wall.camera, wall.camera.eye, {0, 0, 0}, {0, kFixedOne, 0}));
  const Scene alone = [&] {
    Scene s = wall.scene();
    s.instances = {};
    return s;
  }();
  wall.camera.fixed_depth_range = true;
  const effects_test::Drawn free = effects_test::draw_any(effects_of(alone, wall.camera), alone, wall.camera, kView);
  const auto visible = static_cast<int>(std::ranges::count(free.pixels, 0xF800));
  EXPECT_LT(wall.red_pixels(), visible) << "the surface covers some pixels of its own edges";
  wall.materials[1].depth_bias = 300;
  EXPECT_EQ(wall.red_pixels(), visible);
}

TEST(Lines, FadeIntoFogByTheirDistance) {
  World world = World::in_pixels();
  world.material.colour = {240, 160, 80, 255};
  world.line({-640, 0, -32767}, {640, 0, 32767});
  const Fog fog{.colour = {16, 96, 240, 255}, .start = fixed(3.0), .end = fixed(13.0)};
  Scene scene = world.scene();
  scene.fog = &fog;
  const Effects effects = effects_of(scene, world.camera);
  EXPECT_EQ(effects, effect::lines | effect::fog | effect::orthographic);
  const effects_test::Drawn drawn = effects_test::draw_any(effects, scene, world.camera, kView);
  for (int x = 10; x < 86; ++x) {
    const Real w = 8 - 4 * (x + 0.5L - 48) / 40;
    const Real share = std::clamp((13 - w) / 10, Real{0}, Real{1});
    EXPECT_NEAR(drawn.green(x, 32) + 2, static_cast<double>(160 * share + 96 * (1 - share)), 2.6) << x;
  }
}

TEST(Lines, HaveTheColourOfTheirFirstVertex) {
  World world = World::in_pixels();
  world.material.colour = {255, 128, 255, 255};
  world.line({-160, 8, 0}, {160, 8, 0});
  world.point({0, 200, 0});
  world.colours = {{255, 255, 0, 255}, {0, 0, 255, 255}, {0, 0, 255, 255}};
  const Scene scene = world.scene();
  const effects_test::Drawn drawn = effects_test::draw_any(effects_of(scene, world.camera), scene, world.camera, kView);
  EXPECT_EQ(drawn.at(48, 31), (255 >> 3 << 11) | (128 >> 2 << 5));
  EXPECT_EQ(drawn.at(48, 19), 255 >> 3);
}

TEST(Lines, AreRefusedWhereTheyWouldBeDrawnOtherwiseThanAskedFor) {
  const auto refused = [](auto change) {
    World world = World::in_pixels();
    world.line({0, 0, 0}, {100, 0, 0});
    world.scene();
    static constexpr Finish kFinish[1] = {};
    static constexpr std::uint16_t kTexel[1] = {};
    static constexpr Texture kTexture[1] = {{kTexel, 0, 0}};
    change(world);
    Scene scene = world.scene();
    scene.finishes = kFinish;
    scene.textures = kTexture;
    const Status status = validate(scene);
    return status.error == Error::lines && status.needed == 0;
  };
  EXPECT_FALSE(refused([](World&) {}));
  EXPECT_TRUE(refused([](World& w) { w.lines.width = 0; }));
  EXPECT_TRUE(refused([](World& w) { w.lines.width = kMaxLineWidth + 1; }));
  EXPECT_TRUE(refused([](World& w) { w.lines.mesh = 1; }));
  EXPECT_TRUE(refused([](World& w) { w.lines.material = 1; }));
  EXPECT_TRUE(refused([](World& w) { w.lines.transform.m[1][1] = Fixed{1} << 24; }));
  EXPECT_TRUE(refused([](World& w) { w.segments[0].a = 2; }));
  EXPECT_TRUE(refused([](World& w) { w.segments[0].b = 2; }));
  EXPECT_TRUE(refused([](World& w) { w.material.texture = 0; }));
  EXPECT_TRUE(refused([](World& w) { w.material.finish = 0; }));
  EXPECT_TRUE(refused([](World& w) { w.material.depth_slope_bias = 1; }));
  EXPECT_FALSE(refused([](World& w) { w.material.depth_bias = 5; }));
}

TEST(Lines, TakeMemoryOnlyWhereThereAreAny) {
  World world = World::in_pixels();
  world.line({0, 0, 0}, {100, 0, 0});
  Scene scene = world.scene();
  const auto bytes = [&] { return plan(count(scene), kView, effects_of(scene, world.camera)).plan.instance_bytes; };
  EXPECT_EQ(bytes(), kLineSetBytes);
  scene.lines = {};
  EXPECT_EQ(bytes(), 0U);
  EXPECT_EQ(effects_of(scene, world.camera), effect::orthographic);
}

}  // namespace
