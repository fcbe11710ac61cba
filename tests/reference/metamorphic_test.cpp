// Changes to a scene that must not change its picture, or only move it: no reference needed, equality to the pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "../oracle/draw.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::reference {
namespace {

using Pixels = std::vector<std::uint16_t>;

constexpr View kView{.width = 128, .height = 128};

/// With the pipeline for `effects`; empty, with a failure recorded, if the renderer refuses.
Pixels draw(const Scene& scene, const Camera& camera, Effects effects) {
  const picture::Picture drawn = picture::draw(effects, scene, camera, kView);
  EXPECT_TRUE(drawn.status) << message(drawn.status.error);
  return rgb565_of(drawn);
}

Pixels draw(const Scene& scene, const Camera& camera) { return draw(scene, camera, effects_of(scene, camera)); }

std::ptrdiff_t drawn(const Pixels& picture) {
  return std::count_if(picture.begin(), picture.end(), [](std::uint16_t pixel) { return pixel != 0; });
}

/// Units of a position that make one pixel: below, 64 pixels are 1.0, which is 32768 units.
constexpr int kPixel = 512;
/// A snapped coordinate: 1/16 pixel.
constexpr int kLattice = kPixel / 16;

struct Point {
  int x = 0, y = 0;  ///< 1/16 pixels from the centre of the picture, y upwards
};

/// Triangles with every vertex on the lattice of snapped coordinates, seen by an orthographic camera, flat colours.
struct LatticeScene {
  std::vector<Position> positions;
  std::vector<Colour> colours;
  std::vector<Triangle> triangles;
  std::array<Mesh, 1> meshes;
  std::array<Material, 1> materials{Material{.lit = false, .smooth = false, .double_sided = true}};
  std::array<Instance, 1> instances{};

  std::uint16_t add(const Point& point, int z, const Colour& colour) {
    const auto coordinate = [](int c) { return static_cast<std::int16_t>(c * kLattice); };
    positions.push_back({coordinate(point.x), coordinate(point.y), static_cast<std::int16_t>(z)});
    colours.push_back(colour);
    return static_cast<std::uint16_t>(positions.size() - 1);
  }
  /// `z` of the three corners.
  void add(const std::array<Point, 3>& corners, const std::array<int, 3>& z, const Colour& colour) {
    const std::uint16_t a = add(corners[0], z[0], colour), b = add(corners[1], z[1], colour);
    triangles.push_back({a, b, add(corners[2], z[2], colour)});
  }
  Scene scene() {
    meshes[0] = {.positions = positions,
                 .normals = {},
                 .colours = colours,
                 .texcoords = {},
                 .triangles = triangles,
                 .meshlets = {}};
    Scene result;
    result.meshes = meshes;
    result.materials = materials;
    result.instances = instances;
    return result;
  }
  static Camera camera() {
    Camera result;
    result.eye = {0, 0, 4 * kFixedOne};
    result.focal = kFixedOne;  // 64 pixels a unit
    result.projection = Projection::orthographic;
    return result;
  }
  Pixels picture() { return draw(scene(), camera()); }
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int between(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  /// Within `extent` pixels of the centre.
  Point point(int extent) { return {between(-16 * extent, 16 * extent), between(-16 * extent, 16 * extent)}; }
  std::array<Point, 3> corners(int extent) { return {point(extent), point(extent), point(extent)}; }
  Colour colour() {
    const auto channel = [this] { return static_cast<std::uint8_t>(between(40, 255)); };
    return {channel(), channel(), channel(), 255};
  }
  template <class Range>
  void shuffle(Range& range) {
    std::shuffle(range.begin(), range.end(), engine_);
  }

 private:
  std::mt19937 engine_;
};

constexpr unsigned kSeeds = 20;
constexpr int kLayers = 40;

/// Tilted triangles, each in a layer of depth of its own, apart by much more than a code.
LatticeScene layered(unsigned seed, int extent) {
  Random random(seed);
  LatticeScene scene;
  constexpr int kThickness = 60000 / kLayers;
  for (int layer = 0; layer < kLayers; ++layer) {
    const auto depth = [&] { return -30000 + layer * kThickness + random.between(0, kThickness * 3 / 4); };
    scene.add(random.corners(extent), {depth(), depth(), depth()}, random.colour());
  }
  return scene;
}

TEST(Metamorphic, TheOrderOfTrianglesWhoseDepthsDifferDoesNotMatter) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    LatticeScene scene = layered(seed, 60);
    const Pixels picture = scene.picture();
    ASSERT_GT(drawn(picture), 5000);
    Random random(seed);
    random.shuffle(scene.triangles);
    EXPECT_EQ(scene.picture(), picture) << "seed " << seed;
    std::reverse(scene.triangles.begin(), scene.triangles.end());
    EXPECT_EQ(scene.picture(), picture) << "seed " << seed;
  }
}

TEST(Metamorphic, ATriangleSplitAtALatticePointCoversTheSame) {
  int split = 0;
  for (unsigned seed = 0; seed < 10 * kSeeds; ++seed) {
    Random random(seed);
    const Colour colour = random.colour();
    const std::array<Point, 3> corner = random.corners(60);
    const int u = random.between(1, 14), v = random.between(1, 15 - u);  // 16ths
    const auto between = [&](int a, int b, int c) { return (u * a + v * b + (16 - u - v) * c) / 16; };
    const Point inner{between(corner[0].x, corner[1].x, corner[2].x), between(corner[0].y, corner[1].y, corner[2].y)};
    const auto side = [&](std::size_t i) {
      const Point &a = corner[i], &b = corner[(i + 1) % 3];
      return (b.x - a.x) * (inner.y - a.y) - (b.y - a.y) * (inner.x - a.x);
    };
    const bool left = side(0) > 0 && side(1) > 0 && side(2) > 0, right = side(0) < 0 && side(1) < 0 && side(2) < 0;
    if (!left && !right) continue;  // rounding to the lattice put the point outside
    ++split;
    LatticeScene whole, parts;
    whole.add(corner, {0, 0, 0}, colour);
    for (std::size_t i = 0; i < 3; ++i) parts.add({corner[i], corner[(i + 1) % 3], inner}, {0, 0, 0}, colour);
    EXPECT_EQ(parts.picture(), whole.picture()) << "seed " << seed;
  }
  EXPECT_GT(split, 8 * static_cast<int>(kSeeds));
}

TEST(Metamorphic, AnEdgeSplitAtALatticePointCoversTheSame) {
  for (unsigned seed = 0; seed < 10 * kSeeds; ++seed) {
    Random random(seed);
    const Colour colour = random.colour();
    std::array<Point, 3> corner = random.corners(60);
    corner[1] = {corner[0].x + 2 * ((corner[1].x - corner[0].x) / 2),
                 corner[0].y + 2 * ((corner[1].y - corner[0].y) / 2)};
    const Point middle{(corner[0].x + corner[1].x) / 2, (corner[0].y + corner[1].y) / 2};
    LatticeScene whole, parts;
    whole.add(corner, {0, 0, 0}, colour);
    parts.add({corner[0], middle, corner[2]}, {0, 0, 0}, colour);
    parts.add({middle, corner[1], corner[2]}, {0, 0, 0}, colour);
    EXPECT_EQ(parts.picture(), whole.picture()) << "seed " << seed;
  }
}

TEST(Metamorphic, WholePixelsOfMotionMoveThePicture) {
  constexpr Fixed kOnePixel = kFixedOne / 64;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    LatticeScene scene = layered(seed, 30);  // never leaves the picture
    const Pixels picture = scene.picture();
    ASSERT_GT(drawn(picture), 1000);
    Random random(seed);
    const int right = random.between(-30, 30), down = random.between(-30, 30);
    scene.instances[0].transform.m[0][3] = right * kOnePixel;
    scene.instances[0].transform.m[1][3] = -down * kOnePixel;
    Pixels expected(picture.size());
    for (int y = 0; y < kView.height; ++y) {
      for (int x = 0; x < kView.width; ++x) {
        const int from_x = x - right, from_y = y - down;
        if (from_x < 0 || from_y < 0 || from_x >= kView.width || from_y >= kView.height) continue;
        expected[static_cast<std::size_t>(y * kView.width + x)] =
            picture[static_cast<std::size_t>(from_y * kView.width + from_x)];
      }
    }
    EXPECT_EQ(scene.picture(), expected) << "seed " << seed << ", moved by " << right << ", " << down;
  }
}

TEST(Metamorphic, HiddenGeometryDoesNotShow) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Random random(seed);
    LatticeScene scene;
    constexpr std::array<Point, 4> kCorners{Point{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}};
    scene.add({kCorners[0], kCorners[1], kCorners[2]}, {0, 0, 0}, {90, 90, 90, 255});
    scene.add({kCorners[0], kCorners[2], kCorners[3]}, {0, 0, 0}, {90, 90, 90, 255});
    for (int i = 0; i < 10; ++i) {
      scene.add(random.corners(60),
                {random.between(1000, 9000), random.between(1000, 9000), random.between(1000, 9000)}, random.colour());
    }
    const Pixels picture = scene.picture();
    const std::vector<Triangle> visible = scene.triangles;
    for (int i = 0; i < 30; ++i) {
      scene.add(random.corners(55),
                {-random.between(500, 9000), -random.between(500, 9000), -random.between(500, 9000)}, random.colour());
    }
    EXPECT_EQ(scene.picture(), picture) << "seed " << seed << ", drawn last";
    std::rotate(scene.triangles.begin(), scene.triangles.begin() + static_cast<std::ptrdiff_t>(visible.size()),
                scene.triangles.end());
    EXPECT_EQ(scene.picture(), picture) << "seed " << seed << ", drawn first";
  }
}

TEST(Metamorphic, PipelinesWithMoreEffectsDrawTheSame) {
  constexpr Effects kAll = without(effect::all, effect::orthographic);  // a projection is not an addition
  for (const scenes::BuiltIn& built_in : scenes::built_in()) {
    scenes::Staged staged;
    stage(built_in, staged, 1, 12, kView);
    const Pixels picture = draw(staged.scene, staged.camera);
    const Effects called_for = effects_of(staged.scene, staged.camera);
    EXPECT_EQ(draw(staged.scene, staged.camera, called_for | kAll), picture) << built_in.name;
    EXPECT_EQ(draw(staged.scene, staged.camera, called_for | without(effect::of_scenes, effect::orthographic)), picture)
        << built_in.name;
  }
}

/// The scene's own materials, changed.
Pixels with_materials(const char* name, void (*change)(Material&)) {
  scenes::Staged staged;
  stage(*scenes::find(name), staged, 1, 12, kView);
  std::vector<Material> materials(staged.scene.materials.begin(), staged.scene.materials.end());
  for (Material& material : materials) change(material);
  Scene scene = staged.scene;
  scene.materials = materials;
  return draw(scene, staged.camera);
}

TEST(Metamorphic, AnEffectWithoutItsDataIsOff) {
  const auto as_it_is = [](Material&) {};
  // Neither normals nor texture coordinates.
  EXPECT_EQ(with_materials("knot", [](Material& m) { m.lit = true; }), with_materials("knot", as_it_is));
  EXPECT_EQ(with_materials("random10k", [](Material& m) { m.smooth = true; }), with_materials("random10k", as_it_is));
  // Texels without light are what they are.
  EXPECT_EQ(with_materials("cube",
                           [](Material& m) {
                             m.smooth = true, m.colour = {1, 2, 3, 255};
                           }),
            with_materials("cube", as_it_is));
  // But light that is there counts.
  EXPECT_NE(with_materials("knot_lit", [](Material& m) { m.lit = false; }), with_materials("knot_lit", as_it_is));
}

TEST(Metamorphic, AFullTurnOfTheCameraReturns) {
  scenes::Staged staged;
  stage(*scenes::find("teapot"), staged, 0, 1, kView);
  const auto from = [&](Angle phi) {
    Camera camera = staged.camera;
    EXPECT_TRUE(orbit(camera, {0, 0, 0}, 4 * kFixedOne, phi, kFullTurn / 5));
    return draw(staged.scene, camera);
  };
  constexpr int kSteps = 12;
  Pixels before;
  for (int step = 0; step < kSteps; ++step) {
    const Angle phi = step * kFullTurn / kSteps;
    const Pixels picture = from(phi);
    EXPECT_NE(picture, before) << "step " << step;
    EXPECT_EQ(from(phi + kFullTurn), picture) << "step " << step;
    EXPECT_EQ(from(phi - kFullTurn), picture) << "step " << step;
    before = picture;
  }
}

// Four quarter turns, each exact: the model returns to where it was, and in between it does not stay there.
TEST(Metamorphic, FourQuarterTurnsOfTheModelReturn) {
  scenes::Staged staged;
  stage(*scenes::find("teapot"), staged, 0, 1, kView);
  Instance instance = staged.scene.instances[0];
  Scene scene = staged.scene;
  scene.instances = {&instance, 1};
  const Pixels at_rest = draw(scene, staged.camera);
  for (int quarter = 1; quarter <= 4; ++quarter) {
    auto& m = instance.transform.m;  // about y: the rows x and z become z and -x
    for (int column = 0; column < 4; ++column) {
      const Fixed x = m[0][column];
      m[0][column] = m[2][column];
      m[2][column] = -x;
    }
    EXPECT_EQ(draw(scene, staged.camera) == at_rest, quarter == 4) << quarter;
  }
}

}  // namespace
}  // namespace zstrip::reference
