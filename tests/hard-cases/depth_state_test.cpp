// Hard cases D35, D36 and D38 to D40: depth tests, writes and biases of materials, through the whole renderer and in
// every depth format.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "depth_picture.hpp"
#include "generators.hpp"

namespace hard_cases {
namespace {

using picture::DepthKind;
using picture::DepthPicture;
using picture::kDepthKinds;

constexpr std::uint16_t kRed = 0xF800, kBlue = 0x001F;

/// Layers of triangles, each a mesh with a material of its own, drawn in order onto black. The box around each is the
/// same and larger than its triangles, so that no code is at an end of the range.
class Layers {
 public:
  /// Corners on the sub-pixel lattice, if the camera is orthographic.
  Layers& add(const std::vector<Corners2>& triangles, const std::vector<std::array<int, 3>>& z,
              const Material& material, Colour colour) {
    lattices_.emplace_back();
    Lattice& lattice = lattices_.back();
    for (std::size_t i = 0; i < triangles.size(); ++i) lattice.add(triangles[i], kWhite, z[i]);
    lattice.model().colours.clear();
    lattice.model().material = material;
    lattice.model().material.lit = false;
    lattice.model().material.double_sided = true;
    lattice.model().material.colour = colour;
    return *this;
  }

  DepthPicture draw(const DepthKind& kind) {
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Instance> instances;
    for (Lattice& lattice : lattices_) {
      static_cast<void>(lattice.model().scene());  // fills in the mesh
      const auto i = static_cast<std::uint16_t>(meshes.size());
      meshes.push_back(lattice.model().mesh);
      materials.push_back(lattice.model().material);
      instances.push_back({.mesh = i, .material = i});
    }
    Scene scene;
    scene.meshes = meshes;
    scene.materials = materials;
    scene.instances = instances;
    scene.background = {0, 0, 0, 255};
    Camera camera = lattices_.front().camera();
    if (!kind.orthographic) {  // as large on the picture at z = 0
      camera.projection = Projection::perspective;
      camera.focal = 4096 * kFixedOne;
    }
    const Effects effects = effects_of(scene, camera) | kind.effect | effect::statistics;
    return picture::DepthRenderer(effects, kView, kView.height).draw(scene, camera);
  }

 private:
  std::vector<Lattice> lattices_;
};

std::uint16_t pixel(const DepthPicture& picture, int x, int y) {
  return pixel_at({.status = {}, .pixels = picture.pixels, .statistics = {}, .bounds = {}}, x, y);
}

/// Rows top..bottom of columns left..right, in pixels.
std::vector<Corners2> rectangle(int left, int top, int right, int bottom) {
  const int l = left * 16, t = top * 16, r = right * 16, b = bottom * 16;
  return {{{{l, t}, {l, b}, {r, b}}}, {{{l, t}, {r, b}, {r, t}}}};
}
std::vector<std::array<int, 3>> flat(int z) { return {{z, z, z}, {z, z, z}}; }

TEST(HardCases, D35_AllEightComparisons) {
  // Said once more as a table: what passes against a nearer, the same and a farther depth in the z-buffer.
  struct Row {
    DepthTest test;
    bool when_nearer, when_equal, when_farther;
  };
  constexpr Row kRows[] = {
      {DepthTest::never, false, false, false},          {DepthTest::nearer, true, false, false},
      {DepthTest::equal, false, true, false},           {DepthTest::nearer_or_equal, true, true, false},
      {DepthTest::farther, false, false, true},         {DepthTest::not_equal, true, false, true},
      {DepthTest::farther_or_equal, false, true, true}, {DepthTest::always, true, true, true},
  };
  for (const DepthKind& kind : kDepthKinds) {
    for (const Row& row : kRows) {
      for (const bool write : {false, true}) {
        Layers layers;
        layers.add(rectangle(0, 8, 96, 56), {{0, 0, 0}, {0, 0, 0}}, {}, {255, 0, 0, 255});
        const DepthPicture before = layers.draw(kind);
        const Material material{.depth_test = row.test, .depth_write = write};
        for (const auto& [column, z] : {std::pair{8, 9000}, std::pair{40, 0}, std::pair{72, -9000}}) {
          layers.add(rectangle(column, 0, column + 16, 64), flat(z), material, {0, 0, 255, 255});
        }
        const DepthPicture picture = layers.draw(kind);
        ASSERT_TRUE(picture.status);
        const auto expect = [&](int x, int y, bool drawn, std::uint16_t under) {
          EXPECT_EQ(pixel(picture, x, y), drawn ? kBlue : under)
              << kind.name << ' ' << static_cast<int>(row.test) << " at " << x << ',' << y;
          const auto i = static_cast<std::size_t>(y * kView.width + x);
          const bool differs = picture.depth[i] != before.depth[i];
          EXPECT_EQ(differs, drawn && write && !(x >= 40 && x < 56 && under == kRed)) << kind.name << ' ' << x;
        };
        expect(16, 32, row.when_nearer, kRed);
        expect(48, 32, row.when_equal, kRed);
        expect(80, 32, row.when_farther, kRed);
        for (const int x : {16, 48, 80}) expect(x, 4, row.when_nearer, 0);  // cleared cells are the farthest
      }
    }
  }
}

/// A triangle anywhere, its depths within a part of the box.
struct AnyTriangle {
  std::vector<Corners2> corners{any_triangle(between(0, 1) == 0 ? between(1, 90) : between(90, 3000))};
  std::vector<std::array<int, 3>> z{{between(-30000, 30000), between(-30000, 30000), between(-30000, 30000)}};
  DepthKind kind = kDepthKinds[between(0, static_cast<int>(std::size(kDepthKinds)) - 1)];

  Layers twice(const Material& second) const {
    Layers layers;
    layers.add(corners, z, {}, {255, 0, 0, 255}).add(corners, z, second, {0, 0, 255, 255});
    return layers;
  }
};

RC_GTEST_PROP(HardCases, D36_TheSameTriangleTwicePassesEqualEverywhere, ()) {
  const AnyTriangle any;
  const DepthPicture picture = any.twice({.depth_test = DepthTest::equal}).draw(any.kind);
  RC_ASSERT(picture.status);
  RC_ASSERT(picture.statistics.depth_passes == picture.statistics.fragments);
  for (int i = 0; i < kPixels; ++i) RC_ASSERT(pixel(picture, i % kView.width, i / kView.width) != kRed);
}

RC_GTEST_PROP(HardCases, D38_ADecalOneCodeNearerIsNowhereEqual, ()) {
  const AnyTriangle any;
  const auto passes_of_decal = [&](DepthTest test, int bias) {
    const DepthPicture picture = any.twice({.depth_test = test, .depth_bias = bias}).draw(any.kind);
    RC_ASSERT(picture.status);
    // All fragments of the first pass.
    return static_cast<int>(picture.statistics.depth_passes) - static_cast<int>(picture.statistics.fragments / 2);
  };
  const int all = passes_of_decal(DepthTest::always, 0);
  RC_ASSERT(passes_of_decal(DepthTest::equal, 1) == 0);
  RC_ASSERT(passes_of_decal(DepthTest::equal, -1) == 0);
  RC_ASSERT(passes_of_decal(DepthTest::nearer, 1) == all);
  RC_ASSERT(passes_of_decal(DepthTest::nearer, -1) == 0);
  RC_ASSERT(passes_of_decal(DepthTest::farther, -1) == all);
}

/// How far the codes of a triangle move by this material's bias: the same at every pixel.
int moved_by(const AnyTriangle& any, const Material& material) {
  Layers plain, biased;
  plain.add(any.corners, any.z, {}, kWhite);
  biased.add(any.corners, any.z, material, kWhite);
  const DepthPicture before = plain.draw(any.kind), after = biased.draw(any.kind);
  RC_ASSERT(before.status && after.status);
  int moved = 0;
  bool first = true;
  for (std::size_t i = 0; i < before.depth.size(); ++i) {
    RC_ASSERT((before.depth[i] == 0) == (after.depth[i] == 0));
    if (before.depth[i] == 0) continue;
    const auto difference = static_cast<int>(after.depth[i] - before.depth[i]);
    RC_ASSERT(first || difference == moved);
    moved = difference;
    first = false;
  }
  RC_PRE(!first);
  return moved;
}

RC_GTEST_PROP(HardCases, D39_NoSlopeBiasOnSlopeZero, ()) {
  AnyTriangle any;
  any.z[0] = {any.z[0][0], any.z[0][0], any.z[0][0]};
  RC_ASSERT(moved_by(any, {.depth_slope_bias = between(-0x7FFFFFFE, 0x7FFFFFFE)}) == 0);
}

RC_GTEST_PROP(HardCases, D39_SlopeBiasIsTheSteeperSlopeTimesItsFactor, ()) {
  // Orthographic, so that codes are linear in the lattice's z: 65533 of them over twice the depth of the box.
  AnyTriangle any;
  any.kind = kDepthKinds[0];
  for (int& z : any.z[0]) z /= 8;
  const oracle::Triangle exact(any.corners[0]);
  RC_PRE(exact.area() > 5000);
  const long double code = 65533.0L / (2 * 32768 * (1 + 64 / 4096.0L / (1 << 20)));
  /// The larger change of a value, given at the corners, from a pixel to the next one aside or below.
  const auto steepness = [&exact](const std::array<int, 3>& z) {
    const auto at = [&](int x, int y) {
      return static_cast<long double>(exact.value_times_area(x, y, {z[0], z[1], z[2]})) /
             static_cast<long double>(exact.area());
    };
    return std::max(std::abs(at(1, 0) - at(0, 0)), std::abs(at(0, 1) - at(0, 0)));
  };
  const long double steeper = steepness(any.z[0]) * code;
  RC_PRE(steeper < 800);
  const int factor = between(-8 * 65536, 8 * 65536), constant = between(-50, 50);
  const long double expected = constant + steeper * factor / 65536;
  const int moved = moved_by(any, {.depth_bias = constant, .depth_slope_bias = factor});
  // The slope is that of the snapped depths, which differ by up to 1/8 code at each corner, up or down.
  const long double snapped =
      std::max({steepness({1, 1, -1}), steepness({1, -1, 1}), steepness({-1, 1, 1})}) / 8 * std::abs(factor) / 65536;
  const long double rounding = 0.51L + snapped + std::abs(expected) * 0.001L;
  RC_ASSERT(std::abs(moved - expected) <= rounding);
}

RC_GTEST_PROP(HardCases, D39_TheClampHasTheSignOfWhatItLimits, ()) {
  AnyTriangle any;
  for (int& z : any.z[0]) z = z / 2 - 15000;  // in the float's few codes too, 200 from either end
  const int bias = between(-200, 200), clamp = between(0, 150);
  RC_ASSERT(moved_by(any, {.depth_bias = bias, .depth_bias_clamp = clamp}) ==
            (clamp > 0 ? std::min(bias, clamp) : bias));
  RC_ASSERT(moved_by(any, {.depth_bias = bias, .depth_bias_clamp = -clamp}) ==
            (clamp > 0 ? std::max(bias, -clamp) : bias));
}

RC_GTEST_PROP(HardCases, D40_BiasPastTheEndsOfTheCodesClamps, ()) {
  const AnyTriangle any;
  const std::uint32_t largest = any.kind.effect == effect::depth_ranges ? 16382
                                : any.kind.effect == effect::depth_24   ? 16777214
                                                                        : 65534;
  const bool nearer = between(0, 1) == 0;
  Layers layers;
  const int sign = nearer ? 1 : -1;
  layers.add(any.corners, any.z, {.depth_bias = sign * 0x7FFFFFFF, .depth_slope_bias = sign * 0x7FFFFFFF}, kWhite);
  const DepthPicture picture = layers.draw(any.kind);
  RC_ASSERT(picture.status);
  for (const std::uint32_t code : picture.depth) {
    if (code == 0) continue;
    RC_ASSERT(code == (nearer ? largest : 1U));
  }
}

}  // namespace
}  // namespace hard_cases
