// Hard cases B: large coordinates, the hand-over between the two rasterisers, the guard band, extremes of every input.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "generators.hpp"
#include "space.hpp"
#include "zstrip/base/math.hpp"

namespace hard_cases {
namespace {

/// The distance in sub-pixels from the picture's centre from which on a vertex is wide.
constexpr int kNarrow = detail::kNarrowLimit;

RC_GTEST_PROP(HardCases, B17_NarrowAndWideGiveTheSamePixels, ()) {
  const raster_judge::Corners c = with_attributes(any_triangle(between(1, 4000)));
  RC_PRE(raster_judge::area_of(c) > 0);
  raster_judge::Canvas narrow, wide;
  raster_judge::draw_spans(narrow, c, true);
  raster_judge::draw_spans(wide, c, false);
  RC_ASSERT(narrow.depth == wide.depth);
  RC_ASSERT(narrow.colour == wide.colour);
}

RC_GTEST_PROP(HardCases, B17_AVertexOnEitherSideOfTheNarrowLimit, ()) {
  // The first corner steps over the limit, sub-pixel by sub-pixel.
  const int side = between(0, 3);
  const int along = between(-6000, 6000);
  const oracle::Point b = any_point(300), c = any_point(300);
  for (int beyond = -3; beyond <= 3; ++beyond) {
    const int out = (side % 2 == 0 ? 1 : -1) * (kNarrow + beyond);
    const oracle::Point a =
        side < 2 ? oracle::Point{kView.width * 8 + out, along} : oracle::Point{along, kView.height * 8 + out};
    RC_ASSERT(coverage_verdict({{a, b, c}}) == "");
  }
}

RC_GTEST_PROP(HardCases, B18_CoordinatesBeyond16Bits, ()) {
  // Up to 2^20 sub-pixels, 65536 pixels, from the picture's centre.
  const auto far_point = [] {
    return oracle::Point{kView.width * 8 + 32 * between(-32767, 32767), kView.height * 8 + 32 * between(-32767, 32767)};
  };
  const auto near_point = [] {
    return oracle::Point{kView.width * 8 + 32 * between(-30, 30), kView.height * 8 + 32 * between(-20, 20)};
  };
  const int kind = between(0, 2);
  const std::vector<Corners2> triangles{
      {far_point(), kind > 0 ? near_point() : far_point(), kind > 1 ? near_point() : far_point()}};
  RC_ASSERT(coverage_verdict(triangles, 32) == "");
}

/// Orthographic pictures of triangles up to 2^24 pixels wide: beyond the guard band on every side. Corners are given in
/// pixels from the picture's centre.
std::string huge_verdict(const std::array<std::array<std::int64_t, 2>, 3>& corners) {
  Lattice lattice(32);
  Model& model = lattice.model();
  model.material.double_sided = true;
  // One step: 32 sub-pixels times 128 is 256 pixels.
  for (auto& row : model.instance.transform.m)
    for (int i = 0; i < 3; ++i) row[i] *= 128;
  std::array<oracle::Homogeneous, 3> exact;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t x = corners[i][0] / 256, y = corners[i][1] / 256;
    model.positions.push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(-y), 0});
    model.colours.push_back(kWhite);
    exact[i] = {kView.width / 2 + 256.0L * static_cast<long double>(x),
                kView.height / 2 + 256.0L * static_cast<long double>(y), 1};
  }
  model.triangles = {{0, 1, 2}};
  const Picture picture = lattice.draw();
  if (!picture.status) return message(picture.status.error);
  // A corner that is cut off at the guard band is snapped there: 1/32 pixel, and never more on the way to the picture.
  const oracle::SpaceTriangle triangle(exact, 0.5L, 2, 0.07L);
  if (triangle.degenerate()) return {};
  for (int y = 0; y < kView.height; ++y) {
    for (int x = 0; x < kView.width; ++x) {
      const oracle::Verdict verdict = triangle.sees(x, y);
      if (verdict == oracle::Verdict::abstains) continue;
      if ((pixel_at(picture, x, y) != 0) != (verdict == oracle::Verdict::inside)) {
        std::ostringstream text;
        for (const auto& c : corners) text << '{' << c[0] << ',' << c[1] << "} ";
        text << "at " << x << ',' << y;
        return text.str();
      }
    }
  }
  return {};
}

RC_GTEST_PROP(HardCases, B19_TriangleAcrossTheGuardBandOnBothSides, ()) {
  const auto corner = [](int reach) {
    return std::array<std::int64_t, 2>{std::int64_t{256} * between(-reach, reach),
                                       std::int64_t{256} * between(-reach, reach)};
  };
  // The guard band lies 8192 steps of 256 pixels from the centre.
  RC_ASSERT(huge_verdict({corner(30000), corner(30000), corner(between(0, 1) == 0 ? 4 : 30000)}) == "");
}

TEST(HardCases, B19_CoversTheWholePictureFromEverySide) {
  for (std::int64_t reach :
       {std::int64_t{1} << 12, std::int64_t{1} << 18, std::int64_t{1} << 21, std::int64_t{1} << 22}) {
    EXPECT_EQ(huge_verdict({{{-reach, -reach}, {reach, -reach}, {0, reach}}}), "");
    EXPECT_EQ(huge_verdict({{{-reach, reach}, {0, -reach}, {reach, reach}}}), "");
    EXPECT_EQ(huge_verdict({{{-reach, 0}, {reach, -reach}, {reach, reach}}}), "");
    EXPECT_EQ(huge_verdict({{{reach, 0}, {-reach, reach}, {-reach, -reach}}}), "");
  }
}

TEST(HardCases, B20_JustInsideAndJustOutsideTheGuardBand) {
  // A right edge through the picture, whose far corner steps over the guard band: the same pixels.
  const std::int64_t limit = (std::int64_t{1} << detail::kGuardBits) / 16;  // in pixels
  for (std::int64_t top = limit - 1024; top <= limit + 1024; top += 256) {
    EXPECT_EQ(huge_verdict({{{0, -top}, {0, top}, {-top, 0}}}), "") << top;
    EXPECT_EQ(huge_verdict({{{-top, 0}, {top, 0}, {0, top}}}), "") << top;
  }
}

RC_GTEST_PROP(HardCases, B21_AreaAbove16And32Bits, ()) {
  const int bits = between(8, 24);
  const raster_judge::Corners c = with_attributes(any_triangle((1 << bits) - 2000 * (bits > 12 ? 1 : 0)));
  RC_PRE(raster_judge::area_of(c) > 0);
  RC_TAG(raster_judge::area_of(c) >> 32 != 0   ? "above 32 bits"
         : raster_judge::area_of(c) >> 16 != 0 ? "above 16 bits"
                                               : "below");
  raster_judge::Canvas canvas;
  raster_judge::draw_spans(canvas, c, false);
  RC_ASSERT(raster_judge::verdict(canvas, c) == "");
}

RC_GTEST_PROP(HardCases, B22_MatrixAtItsExtremesIsDrawnOrRefused, ()) {
  // Entries at the limits that validate() states, meshes as large as they may be, eyes anywhere.
  Model model = picture::random_model(static_cast<unsigned>(between(0, 1000)), 12, 20000);
  const auto extreme = [](Fixed limit) {
    return between(0, 2) == 0 ? between(-limit, limit) : (between(0, 1) == 0 ? limit : -limit);
  };
  for (auto& row : model.instance.transform.m) {
    for (int i = 0; i < 3; ++i) row[i] = extreme(255 * kFixedOne);
    row[3] = extreme(32767 * kFixedOne);
  }
  model.mesh.half_extent = {extreme(4095 * kFixedOne) & INT32_MAX, 4095 * kFixedOne,
                            extreme(4095 * kFixedOne) & INT32_MAX};
  model.mesh.half_extent.x = std::min(model.mesh.half_extent.x, 4095 * kFixedOne);
  model.mesh.half_extent.z = std::min(model.mesh.half_extent.z, 4095 * kFixedOne);
  model.mesh.centre = {extreme(4095 * kFixedOne), extreme(4095 * kFixedOne), extreme(4095 * kFixedOne)};
  Camera camera;
  camera.eye = {extreme(32767 * kFixedOne), extreme(32767 * kFixedOne), extreme(32767 * kFixedOne)};
  camera.near_plane = between(1, 2 * kFixedOne);
  camera.far_plane = 32767 * kFixedOne;
  if (between(0, 1) == 0) camera.projection = Projection::orthographic;
  const Scene scene = model.scene();
  const Picture whole = picture::render(scene, camera, kView, kView.height);
  if (!whole.status) {
    RC_TAG("refused");
    RC_ASSERT(whole.status.error == Error::instance || whole.status.error == Error::mesh);
    return;
  }
  RC_TAG(whole.statistics.fragments > 0 ? "drawn" : "not in the picture");
  RC_ASSERT(picture::render(scene, camera, kView, 5).pixels == whole.pixels);
}

TEST(HardCases, B23_DistancesOfZeroBelowZeroAndOneUnit) {
  // Triangles with a corner behind the eye, at the eye's plane, and one step of the position grid in front of it.
  for (const int eye_step : {-1, 0, 1, 2, 100, 10000}) {
    for (const int z : {-32767, -1, 0, 1, 2, 3, 32767}) {
      Space space(8 * kFixedOne, 8 * eye_step * 2);  // a step is 8 / 32768, 16 units of 16.16
      space.camera.near_plane = 1;
      space.camera.far_plane = 64 * kFixedOne;
      space.add({{{-20000, -9000, -32767}, {20000, -9000, -32767}, {0, -9000, static_cast<std::int16_t>(z)}}});
      space.add({{{-20000, 9000, -32767}, {0, 9000, static_cast<std::int16_t>(z)}, {20000, 9000, -32767}}});
      const Picture picture = space.draw();
      ASSERT_EQ(space.verdict(picture, 0.15L), "") << eye_step << ' ' << z;
      ASSERT_EQ(space.draw(3).pixels, picture.pixels);
    }
  }
}

TEST(HardCases, B24_ReciprocalOfEvery16BitArgument) {
  std::int64_t previous = std::numeric_limits<std::int64_t>::max();
  double worst = 0;
  for (std::uint32_t argument = 1; argument <= 0xFFFF; ++argument) {
    const detail::Reciprocal r = detail::reciprocal_of(argument);
    const double exact = 1.0 / argument;
    const double got = std::ldexp(static_cast<double>(r.value), r.normalisation - 62);
    worst = std::max(worst, std::abs(got / exact - 1));
    const std::int64_t scaled = std::int64_t{r.value} << r.normalisation;  // 2^62 / argument
    ASSERT_LE(scaled, previous) << argument;
    previous = scaled;
  }
  EXPECT_LT(worst, std::ldexp(1.0, -28));
  RecordProperty("worst_relative_error_times_2_to_28", std::to_string(std::ldexp(worst, 28)));
}

RC_GTEST_PROP(HardCases, B25_MostNegativeIntegers, ()) {
  // INT16_MIN is outside the documented range of positions: harmless all the same. What is undefined, the build with
  // sanitizers stops at.
  Model model = picture::random_model(static_cast<unsigned>(between(0, 1000)), 8, 20000);
  for (Position& p : model.positions) {
    if (between(0, 2) == 0) p = {INT16_MIN, static_cast<std::int16_t>(between(INT16_MIN, INT16_MAX)), INT16_MIN};
  }
  for (Normal& n : model.normals) {
    if (between(0, 2) == 0) n = {INT8_MIN, INT8_MIN, INT8_MIN, 0};
  }
  for (TexCoord& t : model.texcoords) {
    if (between(0, 2) == 0) t = {INT16_MIN, INT16_MIN};
  }
  model.light = {INT16_MIN, INT16_MIN, INT16_MIN, kWhite};
  model.material.texture = between(0, 1) == 0 ? 0 : kNoTexture;
  model.material.lit = between(0, 1) == 0;
  Camera camera;
  if (between(0, 1) == 0) camera.projection = Projection::orthographic;
  const Picture whole = picture::render(model.scene(), camera, kView, kView.height);
  RC_ASSERT(whole.status);
  RC_ASSERT(picture::render(model.scene(), camera, kView, 7).pixels == whole.pixels);
}

}  // namespace
}  // namespace hard_cases
