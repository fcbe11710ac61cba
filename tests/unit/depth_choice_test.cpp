// What each depth format is said to separate, against what the probe of the hard cases measured (docs/numerics.md).
#include "zstrip/plan/depth_choice.hpp"
#include "zstrip/plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace zstrip;

Fixed fixed(double value) { return static_cast<Fixed>(std::lround(value * kFixedOne)); }

double separation(DepthFormat format, const DepthRange& range, double distance) {
  return static_cast<double>(depth_separation(format, range, fixed(distance))) / 4294967296.0;
}

struct Measured {
  DepthFormat format;
  double near, far;
  double tilted[4];  ///< at 1, 3, 10 and 30
};

TEST(DepthChoice, IsEnoughForTiltedSurfacesAndNotTwiceTooMuch) {
  constexpr DepthFormat kZ16 = DepthFormat::z16, kFloat = DepthFormat::float16, kZ24 = DepthFormat::z24;
  const Measured all[] = {
      {kZ16, 0.1, 100, {.00024, .0018, .018, .15}},           {kZ16, 1, 40, {.000027, .00018, .0025, .016}},
      {kFloat, 0.1, 100, {.00010, .00042, .0011, .010}},      {kFloat, 1, 40, {.000075, .00034, .0010, .0042}},
      {kZ24, 0.1, 100, {.0000013, .000011, .000080, .00076}}, {kZ24, 1, 40, {.00000014, .0000012, .000013, .00011}}};
  constexpr double kDistances[] = {1, 3, 10, 30};
  for (const Measured& measured : all) {
    for (int i = 0; i < 4; ++i) {
      const double said = separation(measured.format, {fixed(measured.near), fixed(measured.far)}, kDistances[i]);
      EXPECT_GE(said, measured.tilted[i]) << static_cast<int>(measured.format) << " at " << kDistances[i];
      EXPECT_LE(said, 2.7 * measured.tilted[i]) << static_cast<int>(measured.format) << " at " << kDistances[i];
    }
  }
}

TEST(DepthChoice, TakesTheCheapestThatSorts) {
  constexpr auto kUnits = [](double value) { return static_cast<std::uint64_t>(value * 4294967296.0); };
  constexpr DepthRange kWide{6554, 100 * kFixedOne}, kFitted{kFixedOne, 40 * kFixedOne};
  static_assert(cheapest_depth_format(kFitted, 40 * kFixedOne, kUnits(0.1)) == DepthFormat::z16);
  static_assert(cheapest_depth_format(kWide, 100 * kFixedOne, kUnits(5)) == DepthFormat::z16);
  EXPECT_EQ(cheapest_depth_format(kWide, 100 * kFixedOne, kUnits(0.5)), DepthFormat::float16);
  EXPECT_EQ(cheapest_depth_format(kWide, 100 * kFixedOne, kUnits(0.1)), DepthFormat::z24);
  EXPECT_EQ(cheapest_depth_format(kWide, 100 * kFixedOne, kUnits(0.02)), DepthFormat::z24);
  EXPECT_EQ(cheapest_depth_format(kWide, 100 * kFixedOne, kUnits(0.0001)), DepthFormat::z24) << "nothing sorts that";
  EXPECT_EQ(cheapest_depth_format(kWide, 10 * kFixedOne, kUnits(0.1)), DepthFormat::z16);
  constexpr DepthRange kOrthographic{6554, 100 * kFixedOne, Projection::orthographic};
  EXPECT_EQ(cheapest_depth_format(kOrthographic, 100 * kFixedOne, kUnits(0.005)), DepthFormat::z16);
  EXPECT_EQ(cheapest_depth_format(kOrthographic, 100 * kFixedOne, kUnits(0.001)), DepthFormat::z24);
  EXPECT_EQ(depth_separation(DepthFormat::float16, kOrthographic, kFixedOne), UINT64_MAX);
}

TEST(DepthChoice, NoRangeOverflowsOrFallsWithDistance) {
  for (const Fixed near : {1, 100, 65536, 1 << 24, (1 << 30) + 12345}) {
    for (const Fixed far : {2, 300, 70000, 1 << 25, INT32_MAX}) {
      if (near >= far) continue;
      for (const DepthFormat format : {DepthFormat::z16, DepthFormat::float16, DepthFormat::z24}) {
        const DepthRange range{near, far};
        const std::uint64_t at_near = depth_separation(format, range, near),
                            at_far = depth_separation(format, range, far);
        EXPECT_LE(at_near, at_far) << near << ' ' << far << ' ' << static_cast<int>(format);
        EXPECT_GT(at_far, 0U) << near << ' ' << far << ' ' << static_cast<int>(format);
      }
    }
  }
}

constexpr SceneCounts kCounts{.instances = 2, .triangles = 900, .vertices = 500, .largest_meshlet = 64};
constexpr View kView{.width = 240, .height = 240, .format = PixelFormat::rgb565};

/// 0.1 .. 100, things up to 10, to be sorted if they are so far apart.
constexpr DepthNeed need(double separation) {
  return {{6554, 100 * kFixedOne}, 10 * kFixedOne, static_cast<std::uint64_t>(separation * 4294967296.0)};
}

TEST(PlanWithDepth, HasTheCheapestFormatThatSorts) {
  constexpr PlanWithDepth kPlan = plan(kCounts, kView, effect::gouraud | effect::depth_24, {}, need(0.05));
  static_assert(kPlan.status);
  EXPECT_EQ(kPlan.effects, effect::gouraud) << "the format that was asked for is not needed";
  EXPECT_EQ(kPlan.plan.depth_bytes, 240U * 240 * 2);
  EXPECT_EQ(depth_format(plan(kCounts, kView, {}, {}, need(0.005)).effects), DepthFormat::float16);
  const PlanWithDepth fine = plan(kCounts, kView, {}, {}, need(0.0002));
  EXPECT_EQ(depth_format(fine.effects), DepthFormat::z24);
  EXPECT_EQ(fine.plan.depth_bytes, 240U * 240 * 4);
  EXPECT_EQ(depth_format(plan(kCounts, kView, {}, {}, need(1e-9)).effects), DepthFormat::z24) << "nothing sorts that";
}

TEST(PlanWithDepth, IsThePlanForItsEffects) {
  for (std::uint32_t bytes = 1000; bytes < 300000; bytes += 1777) {
    for (const double separation : {0.05, 0.005, 0.0002}) {
      const PlanWithDepth with_depth = plan(kCounts, kView, effect::lighting, {.bytes = bytes}, need(separation));
      const PlanResult same = plan(kCounts, kView, with_depth.effects, {.bytes = bytes});
      ASSERT_EQ(with_depth.status.error, same.status.error) << bytes;
      ASSERT_EQ(with_depth.plan.bytes(), same.plan.bytes()) << bytes;
      ASSERT_EQ(with_depth.plan.strip_rows, same.plan.strip_rows) << bytes;
    }
  }
}

TEST(PlanWithDepth, MethodsAndSubRangesKeepZ16) {
  EXPECT_EQ(plan(kCounts, kView, effect::depth_ranges, {}, need(0.0002)).effects, effect::depth_ranges);
  EXPECT_EQ(plan(kCounts, kView, method::hierarchical_z, {}, need(0.0002)).effects, method::hierarchical_z);
}

}  // namespace
