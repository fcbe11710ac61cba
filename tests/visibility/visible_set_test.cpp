// Potentially visible sets: nothing that an eye in a cell can see is left out, much of the other room is, and only what
// hides is taken for a wall.
#include "visibility/visible_set_bake.hpp"

#include <algorithm>
#include <cstring>
#include <random>

#include "scenes.hpp"
#include "zstrip/base/crc32.hpp"
#include "zstrip/visibility/visible_sets.hpp"
#include "zstrip/zstrip.hpp"

namespace zstrip::sim::test {
namespace {

constexpr View kView{72, 54, PixelFormat::rgb565};
constexpr CellCounts kCells{12, 1, 8};

class VisibilitySets : public ::testing::Test {
 protected:
  VisibilitySets() {
    Result<std::unique_ptr<Stage>> opened = open_stage(ROOMS, {}, {}, kView, 24);
    EXPECT_TRUE(opened) << opened.failure().message;
    stage_ = std::move(*opened);
    const Result<Staging> placed = stage_->place(5, 24);
    EXPECT_TRUE(placed);
    staging_ = *placed;
    const Result<BakedVisibleSets> baked =
        bake_visible_sets(staging_.scene, staging_.camera, stage_->animation(), kCells);
    EXPECT_TRUE(baked) << baked.failure().message;
    baked_ = *baked;
    EXPECT_EQ(open_visible_sets(baked_.bytes(), count(staging_.scene).meshlets, sets_), Status{});
  }

  /// An eye and where it looks, in rooms of 12x3x6 units.
  Camera somewhere(std::mt19937& random) const {
    const auto between = [&random](double low, double high) {
      return static_cast<Fixed>(std::uniform_real_distribution<double>(low, high)(random) * kFixedOne);
    };
    Camera camera = staging_.camera;
    const Vec3 eye{between(-6, 6), between(0.2, 2.8), between(-2.9, 2.9)};
    const Vec3 target{between(-6, 6), between(0.5, 2.5), between(-3, 3)};
    EXPECT_TRUE(look_at(camera, eye, target, {0, kFixedOne, 0}));
    return camera;
  }

  LookedAtFrame drawn_with(const Camera& camera, std::span<const std::uint32_t> visible, Effects own = {}) const {
    MethodRequest made = request("zbuffer", kView, 54);
    made.effects = method::culling | own;
    made.options.potentially_visible = visible;
    return drawn({staging_.scene, camera}, made);
  }

  std::unique_ptr<Stage> stage_;
  Staging staging_;
  BakedVisibleSets baked_;
  VisibleSets sets_;
};

TEST_F(VisibilitySets, NoEyeInACellMissesWhatItSees) {
  std::mt19937 random(20);
  std::uint64_t left_out = 0, all = 0;
  int with_fewer = 0, pictures_that_need_their_set = 0;
  constexpr int kEyes = 150;
  for (int i = 0; i < kEyes; ++i) {
    const Camera camera = somewhere(random);
    const std::span<const std::uint32_t> visible = sets_.at(camera.eye);
    ASSERT_FALSE(visible.empty());
    const LookedAtFrame whole = drawn_with(camera, {});
    const LookedAtFrame fewer = drawn_with(camera, visible);
    EXPECT_EQ(whole.depth, fewer.depth) << i;
    EXPECT_EQ(whole.pixels, fewer.pixels) << i;
    left_out += fewer.visibility.outside_cells;
    all += fewer.statistics.triangles;
    with_fewer += fewer.visibility.outside_cells != 0 ? 1 : 0;
    // Without what the set has the picture would be another one: the scene is not hidden anyway.
    std::vector<std::uint32_t> none(visible.size(), 0);
    pictures_that_need_their_set += drawn_with(camera, none).pixels != whole.pixels ? 1 : 0;
  }
  EXPECT_GT(with_fewer, kEyes / 2);
  EXPECT_GT(left_out * 100, all * 15);  // the globe alone is 29 % of all triangles
  EXPECT_EQ(pictures_that_need_their_set, kEyes);
}

TEST_F(VisibilitySets, HideAShareOfTheRoomsAndNeverWhatMoves) {
  EXPECT_EQ(baked_.cells, 96U);
  EXPECT_GT(baked_.hidden, 0.2);
  EXPECT_LT(baked_.sets, baked_.cells);
  const std::uint32_t meshlets = count(staging_.scene).meshlets;
  ASSERT_EQ(sets_.meshlets, meshlets);
  for (std::size_t set = 0; set < baked_.sets; ++set) {
    const std::span<const std::uint32_t> words = sets_.sets.subspan(set * ((meshlets + 31) / 32), (meshlets + 31) / 32);
    for (std::uint32_t i = meshlets - 64; i < meshlets; ++i) {  // the globe comes last
      EXPECT_NE(words[i / 32] >> (i % 32) & 1, 0U) << set << ' ' << i;
    }
  }
}

TEST_F(VisibilitySets, GoWithEveryMethodThatCulls) {
  std::mt19937 random(7);
  for (int i = 0; i < 10; ++i) {
    const Camera camera = somewhere(random);
    const LookedAtFrame whole = drawn_with(camera, {});
    for (const Effects own : {method::hierarchical_z, method::front_to_back, method::midpoint_safe}) {
      EXPECT_EQ(whole.depth, drawn_with(camera, sets_.at(camera.eye), own).depth) << i;
    }
  }
}

TEST_F(VisibilitySets, AnEyeOutsideOfAllCellsSeesEverything) {
  const Vec3 inside{sets_.origin.x, sets_.origin.y, sets_.origin.z};
  EXPECT_EQ(sets_.at(inside).data(), sets_.sets.data() + sets_.set_of_cell[0] * sets_.sets.size() / baked_.sets);
  EXPECT_TRUE(sets_.at({inside.x - 1, inside.y, inside.z}).empty());
  EXPECT_TRUE(sets_.at({inside.x + 12 * sets_.cell.x, inside.y, inside.z}).empty());
  EXPECT_FALSE(sets_.at({inside.x + 12 * sets_.cell.x - 1, inside.y, inside.z}).empty());
  EXPECT_TRUE(sets_.at({INT32_MAX, INT32_MIN, 0}).empty());
  EXPECT_TRUE(VisibleSets{}.at({0, 0, 0}).empty());
}

TEST_F(VisibilitySets, DamagedOnesAreRefusedByteByByte) {
  const std::uint32_t meshlets = sets_.meshlets;
  std::vector<std::uint32_t> words = baked_.words;
  const std::span<std::byte> bytes = std::as_writable_bytes(std::span(words));
  VisibleSets opened;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] ^= std::byte{0x10};
    EXPECT_FALSE(open_visible_sets(bytes, meshlets, opened)) << i;
    EXPECT_FALSE(open_visible_sets(bytes.first(i), meshlets, opened)) << i;
    bytes[i] ^= std::byte{0x10};
  }
  EXPECT_EQ(opened.meshlets, 0U);
  EXPECT_EQ(open_visible_sets(bytes, meshlets + 1, opened),
            (Status{.error = Error::blob_damaged, .needed = detail::visible_sets_at::kMeshlets}));
  EXPECT_EQ(open_visible_sets(bytes.subspan(1), meshlets, opened).error, Error::blob_alignment);
  bytes[2] = std::byte{9};
  EXPECT_EQ(open_visible_sets(bytes, meshlets, opened),
            (Status{.error = Error::blob_version, .needed = 9, .available = 1}));
  bytes[2] = std::byte{1};
  // A sound checksum over a cell without a set.
  const auto put = [&](std::size_t at, std::uint16_t value) { std::memcpy(bytes.data() + at, &value, sizeof value); };
  put(detail::visible_sets_at::kCells + 4, 0xFFFF);
  const std::uint32_t checksum = crc32(bytes.subspan(detail::visible_sets_at::kChecked));
  std::memcpy(bytes.data() + detail::visible_sets_at::kChecksum, &checksum, sizeof checksum);
  EXPECT_EQ(open_visible_sets(bytes, meshlets, opened),
            (Status{.error = Error::blob_damaged, .needed = detail::visible_sets_at::kCells + 4}));
}

/// A wall, a small square 1 unit behind it, and something far in front that makes the grid reach there.
struct WalledScene {
  explicit WalledScene(const Material& of_wall) {
    materials = {of_wall, {.lit = false, .double_sided = true}};
    instances.resize(3);
    for (std::size_t i = 0; i < 3; ++i) instances[i].mesh = static_cast<std::uint16_t>(i);
    for (std::size_t i = 1; i < 3; ++i) instances[i].material = 1;
    instances[1].transform.m[2][3] = -kFixedOne;
    instances[2].transform.m[2][3] = 6 * kFixedOne;
    for (const Fixed half : {4 * kFixedOne, kFixedOne / 2, kFixedOne / 2}) {
      meshes.push_back({.positions = kCorners,
                        .normals = {},
                        .colours = {},
                        .texcoords = {},
                        .triangles = kTriangles,
                        .meshlets = {},
                        .centre = {},
                        .half_extent = {half, half, 1}});
    }
  }
  Scene scene() const {
    return {.meshes = meshes,
            .materials = materials,
            .textures = {},
            .instances = instances,
            .lights = {},
            .finishes = kFinishes};
  }
  /// Cells in which the square is left out.
  int hidden(Projection projection = Projection::perspective) const {
    const Result<BakedVisibleSets> baked =
        bake_visible_sets(scene(), camera_at(projection), {}, {.across = 4, .up = 4, .deep = 8});
    if (!baked) return -1;
    VisibleSets sets;
    EXPECT_TRUE(open_visible_sets(baked->bytes(), static_cast<std::uint32_t>(instances.size()), sets));
    int count = 0;
    for (const std::uint16_t set : sets.set_of_cell) {
      EXPECT_EQ(sets.sets[set] & 1, 1U);  // the wall itself
      count += (sets.sets[set] & 2) == 0 ? 1 : 0;
    }
    return count;
  }

  static constexpr Position kCorners[] = {
      {-32767, -32767, 0}, {32767, -32767, 0}, {32767, 32767, 0}, {-32767, 32767, 0}};
  static constexpr Triangle kTriangles[] = {{0, 1, 2}, {0, 2, 3}};
  static constexpr Finish kFinishes[] = {{.alpha_mode = AlphaMode::blend}, {.alpha_mode = AlphaMode::mask}};
  std::vector<Material> materials;
  std::vector<Instance> instances;
  std::vector<Mesh> meshes;
};

TEST(VisibilitySetsOf, OnlyWhatHidesIsAWall) {
  const Material opaque{.lit = false};
  const int hidden = WalledScene(opaque).hidden();
  EXPECT_GT(hidden, 16);
  EXPECT_LT(hidden, 128);
  Material material = opaque;
  material.finish = 0;
  EXPECT_EQ(WalledScene(material).hidden(), 0) << "glass";
  material.finish = 1;
  EXPECT_EQ(WalledScene(material).hidden(), 0) << "lattice";
  material = opaque;
  material.depth_write = false;
  EXPECT_EQ(WalledScene(material).hidden(), 0) << "no depth";
  // Seen from behind it is culled.
  WalledScene turned(opaque);
  turned.instances[0].transform.m[0][0] = turned.instances[0].transform.m[2][2] = -kFixedOne;
  EXPECT_EQ(turned.hidden(), 0);
  turned.materials[0].double_sided = true;
  EXPECT_EQ(turned.hidden(), hidden);
  // Two halves that meet hide what lies behind the seam; with a gap they do not.
  const auto in_halves = [&](Fixed gap) {
    WalledScene halves(opaque);
    halves.instances.push_back(halves.instances[0]);
    halves.instances[0].transform.m[0][3] = -4 * kFixedOne - gap / 2;
    halves.instances[3].transform.m[0][3] = 4 * kFixedOne + gap / 2;
    return halves.hidden();
  };
  EXPECT_GE(in_halves(-kFixedOne / 64), hidden);
  EXPECT_LT(in_halves(kFixedOne / 8), in_halves(-kFixedOne / 64));
  EXPECT_EQ(WalledScene(opaque).hidden(Projection::orthographic), -1);
}

TEST(VisibilitySetsOf, BillboardsHideNothingAndAreNeverHidden) {
  const Material opaque{.lit = false};
  ASSERT_GT(WalledScene(opaque).hidden(), 0);
  for (const std::size_t turning : {0U, 1U}) {  // the wall, and the square behind it
    WalledScene scene(opaque);
    scene.meshes[turning].billboard = Billboard::upright;
    EXPECT_EQ(scene.hidden(), 0) << turning;
  }
}

TEST(VisibilitySetsOf, TheScenesChecksumIsOfWhatStandsStill) {
  const Material opaque{.lit = false};
  const WalledScene walled(opaque);
  WalledScene moved(opaque);
  moved.instances[1].transform.m[0][3] += 1;
  EXPECT_NE(visibility_checksum(walled.scene(), {}), visibility_checksum(moved.scene(), {}));
  const Track track{.instance = 1, .count = 1, .first = 0};
  const Animation animation{.tracks = {&track, 1}, .keyframes = {}};
  EXPECT_EQ(visibility_checksum(walled.scene(), animation), visibility_checksum(moved.scene(), animation));
  WalledScene glass(opaque);
  glass.materials[0].finish = 0;
  EXPECT_NE(visibility_checksum(walled.scene(), {}), visibility_checksum(glass.scene(), {}));
}

}  // namespace
}  // namespace zstrip::sim::test
