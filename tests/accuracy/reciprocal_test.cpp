// Short reciprocals: how coarse, and that surfaces stay closed, codes in order and strips alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>

#include "accuracy/measure.hpp"
#include "accuracy/observation.hpp"
#include "zstrip/base/math.hpp"
#include "zstrip/effects/exclusions.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::sim {
namespace {

constexpr Budget kWhole{.strip_rows = 96, .modes = Modes::streamed};

std::unique_ptr<AccuracyScene> scene(const char* name) {
  auto opened = AccuracyScene::open({.scene = name, .view = {128, 96}, .frames = 2, .firmware = ""});
  EXPECT_TRUE(opened) << opened.failure().message;
  return std::move(*opened);
}

// Not only 2^-9: what rounds the table's 16 bits comes on top.
TEST(TableReciprocal, IsRightTo9Bits) {
  double lowest = 0, highest = 0;
  for (std::uint64_t divisor = std::uint64_t{1} << 31; divisor < std::uint64_t{1} << 32; divisor += 65521) {
    const std::int32_t found = table_reciprocal(static_cast<std::uint32_t>(divisor));
    EXPECT_GE(found, std::int32_t{1} << 30) << divisor;
    const double exact = std::ldexp(1.0, 62) / static_cast<double>(divisor), off = found / exact - 1;
    lowest = std::min(lowest, off);
    highest = std::max(highest, off);
  }
  const double bound = std::ldexp(1.0, -9) + std::ldexp(1.0, -16);
  EXPECT_LT(highest, bound);
  EXPECT_GT(lowest, -bound);
  EXPECT_GT(highest, std::ldexp(1.0, -10));
}

TEST(CoarseReciprocal, IsRightTo15Bits) {
  double worst = 0;
  for (std::uint64_t divisor = std::uint64_t{1} << 31; divisor < std::uint64_t{1} << 32; divisor += 65521) {
    const double exact = std::ldexp(1.0, 62) / static_cast<double>(divisor);
    const double off = coarse_reciprocal(static_cast<std::uint32_t>(divisor)) / exact - 1;
    EXPECT_GT(off, -std::ldexp(1.0, -16)) << divisor;
    worst = std::max(worst, off);
  }
  EXPECT_LT(worst, std::ldexp(1.0, -15));
  EXPECT_GT(worst, std::ldexp(1.0, -16));
}

/// With either of them.
class ShortReciprocal : public testing::TestWithParam<bool> {
 protected:
  static bool by_table() { return GetParam(); }
  static int room_bits() { return by_table() ? detail::kRoomForTable : detail::kRoomForCoarse; }
  static Effects effects() { return by_table() ? effect::table_reciprocal : effect::coarse_reciprocal; }
  static std::int32_t reciprocal_of(std::uint32_t divisor) {
    return by_table() ? table_reciprocal(divisor) : coarse_reciprocal(divisor);
  }
};
INSTANTIATE_TEST_SUITE_P(, ShortReciprocal, testing::Bool(),
                         [](const auto& tested) { return tested.param ? "Table" : "Coarse"; });

// Corners of the floor and walls are clipped beside those that are not.
TEST_P(ShortReciprocal, LeavesNoHolesBesideWhatIsClipped) {
  const auto room = scene("room");
  for (const Staging& staged : room->staged()) {
    const Result<Drawn> fine = draw(staged, {128, 96}, {}, kWhole, true);
    const Result<Drawn> shorter = draw(staged, {128, 96}, effects(), kWhole, true);
    ASSERT_TRUE(fine && shorter);
    EXPECT_NE(fine->code, shorter->code);
    for (std::size_t i = 0; i < fine->code.size(); ++i) EXPECT_EQ(fine->code[i] == 0, shorter->code[i] == 0) << i;
  }
}

/// Two squares at the very ends of the depth range.
struct Ends {
  std::array<Position, 4> positions{{{-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}}};
  std::array<Triangle, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
  std::array<Material, 2> materials{
      {{.colour = {255, 0, 0, 255}, .lit = false}, {.colour = {0, 255, 0, 255}, .lit = false}}};
  std::array<Mesh, 1> meshes{};
  std::array<Instance, 2> instances{};
  Staging staged{};

  Ends(Fixed distance, Fixed between) {
    meshes[0].positions = positions;
    meshes[0].triangles = triangles;
    meshes[0].half_extent = {4 * kFixedOne, 4 * kFixedOne, 0};
    // The far one is drawn last: it must not come in front.
    instances[0].transform.m[2][3] = -distance;
    instances[1].transform.m[2][3] = -distance - between;
    instances[1].material = 1;
    staged.scene.meshes = meshes;
    staged.scene.materials = materials;
    staged.scene.instances = instances;
    staged.camera.eye = {0, 0, 0};
    staged.camera.focal = 2 * kFixedOne;
  }
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;
};

// The error of the near end is 2^-15 of 1/w or 2^-9, which is many codes where both ends are close together.
TEST_P(ShortReciprocal, KeepsTheEndsOfTheRangeInOrder) {
  for (int step = 0; step < 400; ++step) {
    const Fixed distance = 4 * kFixedOne + step * 601;
    const Ends ends(distance, distance / (2 + step % 50));
    const Result<Drawn> drawn =
        draw(ends.staged, {64, 48}, effects(), {.strip_rows = 48, .modes = Modes::streamed}, true);
    ASSERT_TRUE(drawn) << drawn.failure().message;
    const std::uint32_t middle = drawn->code[24 * 64 + 32];
    // The room at the near end and the error of a reciprocal, half of it, as parts of 1/w, of whose span codes count.
    const double room = std::ldexp(1.0, -room_bits());
    EXPECT_GT(middle, 65532 - 65533 * 1.5 * room * (3 + step % 50)) << step;
    EXPECT_LE(middle, 65534U) << step;
    std::uint16_t word = 0;
    std::memcpy(&word, drawn->pixels.data() + 2 * (24 * 64 + 32), 2);
    EXPECT_EQ(word, 0xF800) << step;
  }
}

/// The code of a vertex at distance w, which ends at 65535, in double precision: only its reciprocal is the renderer's.
template <class Reciprocal>
double code_of(const DepthFit& fit, double w, const Reciprocal& reciprocal_of) {
  int exponent = 0;
  const auto divisor = static_cast<std::uint32_t>(std::ldexp(std::frexp(w, &exponent), 32));
  const double inverse = std::ldexp(reciprocal_of(divisor), -30 - exponent);
  return (static_cast<double>(fit.quotient_at_near) * static_cast<double>(fit.near) * inverse -
          static_cast<double>(fit.offset)) /
         65536;
}

// The room is what keeps them there: with the fit of other reciprocals codes run over both ends, and the nearest
// surface becomes the farthest.
TEST_P(ShortReciprocal, CodesStayWithinTheirRangeByItsRoomAlone) {
  const double room = std::ldexp(1.0, -room_bits());
  int below = 0, above = 0;
  for (double near = 0.01; near < 20000; near *= 1.0173) {
    for (double ratio = 1.004; near * ratio < 32767; ratio = 1 + (ratio - 1) * 1.37) {
      const auto at = [](double length) { return static_cast<Distance>(std::ldexp(length, kDistanceBits)); };
      const DepthFit narrow = fit_depth(at(near), at(near * ratio));
      const DepthFit fit = detail::with_room(narrow, room_bits());
      const auto nearest = static_cast<double>(fit.near), farthest = static_cast<double>(fit.far);
      ASSERT_LT(code_of(fit, nearest, reciprocal_of), 65535) << near << ' ' << ratio;
      ASSERT_GE(code_of(fit, farthest, reciprocal_of), 1) << near << ' ' << ratio;
      // Of what is thinner both errors and the room at both ends take more than half.
      if (ratio > 1 + 5 * room) {
        ASSERT_GT(code_of(fit, nearest, reciprocal_of), code_of(fit, farthest, reciprocal_of) + 32768)
            << near << ' ' << ratio;
      }
      above += code_of(narrow, nearest, reciprocal_of) >= 65535 ? 1 : 0;
      below += code_of(narrow, farthest, reciprocal_of) < 1 ? 1 : 0;
    }
  }
  EXPECT_GT(above, 0);
  EXPECT_GT(below, 0);
}

TEST_P(ShortReciprocal, IsTheSameInStripsAndBins) {
  const auto knot = scene("knot_meshlets");
  const Staging& staged = knot->staged()[0];
  const Result<Drawn> whole = draw(staged, {128, 96}, effects(), kWhole, false);
  const Result<Drawn> strips = draw(staged, {128, 96}, effects(), {.strip_rows = 8, .modes = Modes::streamed}, false);
  const Result<Drawn> bins =
      draw(staged, {128, 96}, effects() | effect::bins, {.strip_rows = 16, .modes = Modes::binned}, false);
  ASSERT_TRUE(whole && strips && bins);
  EXPECT_EQ(strips->pixels, whole->pixels);
  EXPECT_EQ(bins->pixels, whole->pixels);
}

TEST_P(ShortReciprocal, IsForZ16WithoutShadowsAlone) {
  EXPECT_TRUE(effects_agree(effects()));
  for (const Effects other : {effect::depth_24, effect::depth_ranges, effect::shadows}) {
    EXPECT_FALSE(effects_agree(effects() | other));
  }
  EXPECT_FALSE(methods_agree(effects() | method::hierarchical_z));
}

}  // namespace
}  // namespace zstrip::sim
