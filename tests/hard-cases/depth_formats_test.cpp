// Hard cases D and E once more, for every depth format: planes, constant depth, long spans, the mapping, strips.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "depth_judge.hpp"
#include "depth_picture.hpp"
#include "generators.hpp"
#include "space.hpp"

namespace hard_cases {
namespace {

using depth_judge::Canvas;
using picture::DepthKind;
using picture::DepthPicture;
using picture::kDepthKinds;

template <DepthFormat value>
struct Format {
  static constexpr DepthFormat format = value;
};
using Formats = testing::Types<Format<DepthFormat::float16>, Format<DepthFormat::z24>>;

/// A depth as vertices have it: of floats every octave is equally likely.
template <DepthFormat format>
std::uint32_t any_depth_of() {
  const auto bits =
      (static_cast<std::uint32_t>(between(0, 0xFFFF)) << 16) | static_cast<std::uint32_t>(between(0, 0xFFFF));
  if constexpr (format == DepthFormat::float16) {
    return detail::snap_depth_as<format>(std::min(bits, 0xFFF80000U) >> between(0, 14));
  } else {
    return detail::snap_depth_as<format>(std::clamp(bits, 0x180U, 0xFFFFFE80U));
  }
}

/// The same depth or one a code farther.
template <DepthFormat format>
std::uint32_t same_or_next(std::uint32_t depth) {
  const std::uint32_t code = format == DepthFormat::float16 ? 1U << (12 + float16_octave(depth)) : 256;
  if (between(0, 1) == 0 || depth < 3 * code) return depth;
  return detail::snap_depth_as<format>(depth - code);
}

/// `depths` in the order of the corners; counter-clockwise.
raster_judge::Corners corners(const Corners2& points, std::array<std::uint32_t, 3> depths) {
  raster_judge::Corners c = with_attributes(points);
  for (std::size_t i = 0; i < 3; ++i) c[i].depth = depths[i];
  RC_PRE(raster_judge::area_of(c) > 0);
  return c;
}

template <class F>
class HardCasesOfFormat : public testing::Test {};
TYPED_TEST_SUITE(HardCasesOfFormat, Formats);

/// Through both rasterisers, if the format has both.
template <DepthFormat format>
void judge(const raster_judge::Corners& c, long double& worst) {
  for (const bool small : {false, true}) {
    Canvas<format> canvas{raster_judge::kWidth, raster_judge::kHeight};
    if (!depth_judge::draw(canvas, c, small)) continue;
    RC_ASSERT(depth_judge::verdict(canvas, c, &worst) == "");
  }
}

TYPED_TEST(HardCasesOfFormat, D41_D43_DepthIsWithinOneCodeOfThePlaneAndInsideItsVerticesRange) {
  constexpr DepthFormat kFormat = TypeParam::format;
  long double worst = 0;
  const bool passed = rc::check([&] {
    const int extent = between(0, 1) == 0 ? between(1, 90) : between(90, 3000);
    judge<kFormat>(
        corners(any_triangle(extent), {any_depth_of<kFormat>(), any_depth_of<kFormat>(), any_depth_of<kFormat>()}),
        worst);
  });
  EXPECT_TRUE(passed) << "anywhere";
  EXPECT_TRUE(rc::check([&] {
    // Next to each other: no room for an error.
    const std::uint32_t depth = any_depth_of<kFormat>();
    judge<kFormat>(
        corners(any_triangle(between(1, 1500)), {depth, same_or_next<kFormat>(depth), same_or_next<kFormat>(depth)}),
        worst);
  })) << "next to each other";
  EXPECT_TRUE(rc::check([&] {
    // Edge-on.
    const oracle::Point a = any_point(), b = point_near(a, between(20, 1200));
    judge<kFormat>(corners({{a, b, {b.x + between(-2, 2), b.y + between(-2, 2)}}},
                           {any_depth_of<kFormat>(), any_depth_of<kFormat>(), any_depth_of<kFormat>()}),
                   worst);
  })) << "edge-on";
  this->RecordProperty("worst_in_codes", std::to_string(worst));
}

TYPED_TEST(HardCasesOfFormat, D48_ALongSpanEndsWithinOneCode) {
  constexpr DepthFormat kFormat = TypeParam::format;
  long double worst = 0;
  EXPECT_TRUE(rc::check([&] {
    const std::int32_t top = between(0, 15), bottom = top + between(17, 48);
    raster_judge::Corners c = corners({{{between(0, 15), top}, {0, bottom}, {4096 * 16 - between(0, 15), top}}},
                                      {any_depth_of<kFormat>(), any_depth_of<kFormat>(), any_depth_of<kFormat>()});
    Canvas<kFormat> canvas{4096, 4};
    depth_judge::draw(canvas, c, false);
    RC_ASSERT(depth_judge::verdict(canvas, c, &worst) == "");
  }));
  this->RecordProperty("worst_in_codes", std::to_string(worst));
}

TEST(HardCases, D48_SteppedWideDepthIsTheClosedForm) {
  EXPECT_TRUE(rc::check([] {
    const detail::WidePlane plane{*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::arbitrary<std::uint64_t>(), 0};
    std::uint64_t stepped = plane.start;
    for (int column = 0; column < 4096; ++column) {
      if (column == 320 || column == 4095) RC_ASSERT(stepped == plane.at(column, 0));
      stepped += plane.step_x;
    }
  }));
}

TEST(HardCases, D45_EveryFormatHasTheDocumentedMapping) {
  // Facing squares at near, at far and in between; the code of the middle one against the formulas of conventions.md.
  for (const DepthKind& kind : kDepthKinds) {
    for (const bool orthographic : {false, true}) {
      if (orthographic && !kind.orthographic) continue;
      double worst = 0;
      for (const auto& [near, far] : {std::pair{1.0, 10.0}, std::pair{1.0, 1000.0}, std::pair{0.3, 3000.0}}) {
        for (double fraction = 0.01; fraction < 1; fraction += 0.02) {
          Model model;
          model.positions = {{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
          model.triangles = {{0, 1, 2}, {0, 2, 3}};
          model.mesh.half_extent = {kFixedOne, kFixedOne, 0};
          model.material = {.lit = false, .smooth = false};
          const double distances[3] = {near * std::pow(far / near, fraction), near, far};
          std::array<Instance, 3> instances;
          for (std::size_t i = 0; i < 3; ++i) {
            instances[i].transform.m[2][3] = -static_cast<Fixed>(distances[i] * 65536);
            // Only the middle one stands before the camera.
            if (i > 0)
              instances[i].transform.m[0][3] =
                  static_cast<Fixed>((orthographic ? 20 : 8 * distances[i]) * 65536) + 2 * kFixedOne;
          }
          Scene scene = model.scene();
          scene.instances = instances;
          Camera camera;
          camera.eye = {0, 0, 0};
          camera.focal = orthographic ? kFixedOne / 2 : static_cast<Fixed>(distances[0] * 65536 * 1.5) + kFixedOne;
          if (!orthographic) camera.focal = std::min<Fixed>(camera.focal, 400 * kFixedOne);
          camera.near_plane = kFixedOne / 16;
          camera.far_plane = 32700 * kFixedOne;
          if (orthographic) camera.projection = Projection::orthographic;
          const DepthPicture drawn = picture::render_depth(scene, camera, kView, kind.effect);
          ASSERT_TRUE(drawn.status);
          const std::uint32_t code = drawn.depth[32 * 96 + 48];
          ASSERT_NE(code, 0U) << kind.name << ' ' << distances[0];
          // The fit is wider than the bounds by 2^-20 on either side.
          const double w = instances[0].transform.m[2][3] / -65536.0,
                       n = instances[1].transform.m[2][3] / -65536.0 * (1 - 0x1p-20),
                       f = instances[2].transform.m[2][3] / -65536.0 * (1 + 0x1p-20);
          const double position = orthographic ? (f - w) / (f - n) : (1 / w - 1 / f) / (1 / n - 1 / f);  // 0 .. 1
          const auto between_codes = [&](double first, double last, double at) { return first + (last - first) * at; };
          double exact = 0;
          switch (depth_format(kind.effect)) {
            case DepthFormat::z16:
              exact = between_codes(1, kind.effect == effect::depth_ranges ? 16382 : 65534, position);
              break;
            case DepthFormat::z24: exact = between_codes(1, (1 << 24) - 2, position); break;
            case DepthFormat::float16:
              exact = static_cast<double>(
                  depth_judge::exact_code<DepthFormat::float16>(depth_judge::kMaxNearOverW * n / w));
              break;
          }
          worst = std::max(worst, std::abs(code - exact));
        }
      }
      // Half a code of rounding and what the vertex's snapping to eighths adds.
      EXPECT_LE(worst, 0.63) << kind.name;
      RecordProperty(std::string(kind.name) + (orthographic ? "_orthographic" : "_perspective"), std::to_string(worst));
    }
  }
}

TEST(HardCases, D47_ConstantDepthIsExactInEveryFormat) {
  for (const DepthKind& kind : kDepthKinds) {
    for (const View view : {View{96, 64}, View{4096, 2}, View{3, 4096}}) {
      for (int z = -32767; z <= 32767; z += 5461) {
        Space space(kFixedOne, 3 * kFixedOne);
        const auto at = static_cast<std::int16_t>(z);
        space.add({{{-32767, -32767, at}, {32767, -32767, at}, {32767, 32767, at}}});
        space.add({{{-32767, -32767, at}, {32767, 32767, at}, {-32767, 32767, at}}});
        space.camera.focal = 5 * kFixedOne * std::max(1, view.width / view.height + 1);
        const DepthPicture drawn = picture::render_depth(space.model.scene(), space.camera, view, kind.effect);
        ASSERT_TRUE(drawn.status);
        ASSERT_NE(drawn.depth.front(), 0U);
        for (const std::uint32_t code : drawn.depth) ASSERT_EQ(code, drawn.depth.front()) << kind.name << ' ' << z;
      }
    }
  }
}

/// A random scene of any effects and one of the kinds of depth, its materials with any depth state.
struct AnyDepthScene {
  Model model;
  Camera camera;
  View view;
  DepthKind kind;

  AnyDepthScene() : kind(kDepthKinds[between(0, static_cast<int>(std::size(kDepthKinds)) - 1)]) {
    model = picture::random_model(static_cast<unsigned>(between(0, 1'000'000)), between(1, 60),
                                  between(0, 1) == 0 ? 1500 : 20000);
    if (between(0, 1) == 0) {
      model.material.texture = 0;
    } else {
      model.texels.clear();
    }
    model.material.lit = between(0, 1) == 0;
    model.material.smooth = between(0, 1) == 0;
    if (between(0, 1) == 0) {
      model.material.depth_test = static_cast<DepthTest>(between(0, 7));
      model.material.depth_write = between(0, 3) != 0;
      model.material.depth_bias = between(-300, 300);
      model.material.depth_slope_bias = between(-300'000, 300'000);
      model.material.depth_bias_clamp = between(-500, 500);
    }
    if (kind.orthographic && between(0, 2) == 0) camera.projection = Projection::orthographic;
    if (between(0, 2) == 0) camera.eye = {between(-60000, 60000), between(-60000, 60000), between(-60000, 60000)};
    if (between(0, 3) == 0) camera.near_plane = between(1, 60000);
    view = {static_cast<std::uint16_t>(between(1, 70)), static_cast<std::uint16_t>(between(1, 50)),
            static_cast<PixelFormat>(between(0, 3))};
  }
};

RC_GTEST_PROP(HardCases, E51_StripHeightChangesNeitherPixelNorDepthInAnyFormat, ()) {
  AnyDepthScene any;
  const Scene scene = any.model.scene();
  const Effects effects = effects_of(scene, any.camera) | any.kind.effect;
  const DepthPicture whole = picture::DepthRenderer(effects, any.view, any.view.height, 0).draw(scene, any.camera);
  RC_ASSERT(whole.status);
  for (const int rows : {1, 2, 3, 7, 16}) {
    if (rows > any.view.height) break;
    picture::DepthRenderer in_strips(effects, any.view, static_cast<std::uint16_t>(rows),
                                     static_cast<std::uint8_t>(between(0, 255)));
    const DepthPicture strips = in_strips.draw(scene, any.camera);
    RC_ASSERT(strips.pixels == whole.pixels);
    RC_ASSERT(strips.depth == whole.depth);
    RC_ASSERT(in_strips.draw(scene, any.camera).depth == whole.depth);
  }
}

TEST(HardCases, D42_FormatsThatNeedPerspectiveOrExcludeEachOtherAreRefused) {
  Lattice lattice;
  lattice.add({{{0, 0}, {0, 400}, {400, 0}}});
  const Scene scene = lattice.model().scene();
  const auto status = [&](const Camera& camera, Effects more) {
    return picture::render_depth(scene, camera, kView, more).status.error;
  };
  for (const DepthKind& kind : kDepthKinds) {
    EXPECT_EQ(status(lattice.camera(), kind.effect), kind.orthographic ? Error::none : Error::depth_effects);
    EXPECT_EQ(status(Camera{}, kind.effect), Error::none);
  }
  EXPECT_EQ(status(Camera{}, effect::depth_24 | effect::depth_float), Error::depth_effects);
  EXPECT_EQ(status(Camera{}, effect::depth_float | effect::depth_ranges), Error::depth_effects);
}

}  // namespace
}  // namespace hard_cases
