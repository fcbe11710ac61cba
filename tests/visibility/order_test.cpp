// Where no order of whole triangles is right: what the painter draws wrong, and what newell and bsp mend.
#include "scenes.hpp"
#include "visibility/bsp_bake.hpp"
#include "visibility/newell.hpp"
#include "zstrip/visibility/bsp_order.hpp"

namespace zstrip::sim::test {
namespace {

constexpr View kView{120, 120, PixelFormat::rgb565};

struct Case {
  const char* name;
  std::vector<Corners> triangles;
};
std::vector<Case> cases() { return {{"thesis", thesis_polygons()}, {"cycle", cycle()}, {"crossing", crossing()}}; }

TEST(Visibility, ThePainterIsWrongWhereNoOrderIsRightAndTheOthersAreNot) {
  for (const Case& c : cases()) {
    const SoupScene scene = scene_of(c.triangles);
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
      const Staging staging{scene.scene(), camera_at(projection)};
      // The thesis's polygons have a right order, but not by their nearest vertices.
      MethodRequest painter = request("painter", kView);
      painter.options.key = SortKey::nearest;
      EXPECT_GT(wrong(staging, painter), 10) << c.name;
      EXPECT_EQ(wrong(staging, request("zbuffer", kView)), 0) << c.name;
      EXPECT_EQ(wrong(staging, request("painter-newell", kView)), 0) << c.name;
      EXPECT_EQ(wrong(staging, request("painter-bsp", kView)), 0) << c.name;
    }
  }
}

TEST(Visibility, OneTreeServesEveryEye) {
  const SoupScene scene = scene_of(cycle());
  Result<PolygonSoup> soup = soup_of(scene.scene());
  ASSERT_TRUE(soup);
  const Result<BakedBsp> baked = bake_bsp(*soup);
  ASSERT_TRUE(baked);
  EXPECT_GT(baked->splits, 0U);
  for (Angle phi = 0; phi < kFullTurn; phi += kFullTurn / 8) {
    Camera camera = camera_at(Projection::perspective);
    ASSERT_TRUE(orbit(camera, {3 * kFixedOne, 3 * kFixedOne, -kFixedOne}, 9 * kFixedOne, phi, kFullTurn / 5));
    EXPECT_EQ(wrong({scene.scene(), camera}, request("painter-bsp", kView)), 0) << phi;
    EXPECT_EQ(wrong({scene.scene(), camera}, request("painter-newell", kView)), 0) << phi;
  }
}

TEST(Visibility, NewellMovesBeforeItSplits) {
  // The thesis's polygons only need the other order.
  const SoupScene scene = scene_of(thesis_polygons());
  const Result<NewellOrder> two = newell_order(*soup_of(scene.scene()), camera_at(Projection::orthographic));
  ASSERT_TRUE(two);
  EXPECT_EQ(two->soup.polygons.size(), 2 + two->splits);
  const SoupScene three = scene_of(cycle());
  const Result<NewellOrder> split = newell_order(*soup_of(three.scene()), camera_at(Projection::orthographic));
  ASSERT_TRUE(split);
  EXPECT_GT(split->splits, 0U);
}

TEST(Visibility, ATreeThatIsNoneIsRefused) {
  const detail::BspEye eye{0, 0, 65536, false};
  const auto order = [&](const std::vector<BspNode>& nodes) {
    std::uint32_t triangles = 0;
    const bool whole = detail::for_each_bsp_run({nodes}, eye, 4, [&](std::uint32_t, std::uint32_t count) {
      triangles += count;
      return true;
    });
    EXPECT_TRUE(!whole || nodes.empty() || triangles == 4);
    return whole;
  };
  BspNode node{};
  node.z = 1 << 30;
  EXPECT_TRUE(order({}));
  EXPECT_TRUE(order({node}));
  BspNode late = node;
  late.first_triangle = 1;
  EXPECT_FALSE(order({late}));
  for (const std::uint32_t child : {1U, 7U, UINT32_MAX}) {
    BspNode lost = node;
    lost.front = child;
    EXPECT_FALSE(order({lost}));
    lost = node;
    lost.back = child;
    EXPECT_FALSE(order({lost}));
  }
  BspNode parent = node, child = node;
  parent.back = 1;
  child.first_triangle = 2;
  EXPECT_TRUE(order({parent, child}));
  for (const std::uint32_t beyond : {5U, UINT32_MAX}) {
    child.first_triangle = beyond;
    EXPECT_FALSE(order({parent, child}));
  }
  child.first_triangle = 2;
  child.back = 1;  // itself
  EXPECT_FALSE(order({parent, child}));
  child.back = 0;
  child.parent = 1;
  EXPECT_FALSE(order({parent, child}));
  child.parent = 0;
  EXPECT_FALSE(order({node, child})) << "nobody's child";
  parent.front = 1;
  EXPECT_FALSE(order({parent, child})) << "both sides are one";
  // Two parents of one child, over and over.
  std::vector<BspNode> shared(20, node);
  for (std::uint32_t i = 0; i + 1 < shared.size(); ++i) {
    shared[i].front = shared[i].back = i + 1;
    shared[i + 1].parent = i;
  }
  EXPECT_FALSE(order(shared));
}

// There is no stack that could be too small.
TEST(Visibility, ATreeOfAnyDepthIsWalked) {
  constexpr std::uint32_t kDepth = 5000;
  std::vector<BspNode> deep(kDepth);
  for (std::uint32_t i = 0; i < kDepth; ++i) {
    deep[i].z = 1 << 30;
    deep[i].first_triangle = i;
    if (i + 1 < kDepth) (i % 3 == 0 ? deep[i].front : deep[i].back) = i + 1;
    if (i != 0) deep[i].parent = i - 1;
  }
  for (const std::int64_t z : {-65536, 65536}) {
    std::vector<int> visits(kDepth, 0);
    EXPECT_TRUE(
        detail::for_each_bsp_run({deep}, {0, 0, z, false}, kDepth, [&](std::uint32_t first, std::uint32_t count) {
          EXPECT_EQ(count, 1U);
          ++visits[first];
          return true;
        }));
    EXPECT_EQ(visits, std::vector<int>(kDepth, 1));
  }
}

// Whole meshes: closed ones, whose polygons all lie behind each other's planes, and soups.
TEST(Visibility, ATreeOfAMeshIsShallowAndHasFewPieces) {
  for (const char* name : {"knot", "knot_meshlets", "teapot_meshlets", "random10k"}) {
    scenes::Staged staged;
    scenes::stage_workload(*scenes::find(name), staged, 7);
    const Result<PolygonSoup> soup = soup_of(staged.scene);
    ASSERT_TRUE(soup) << name;
    const Result<BakedBsp> baked = bake_bsp(*soup);
    ASSERT_TRUE(baked) << name << baked.failure().message;
    EXPECT_LT(baked->depth, 200U) << name;
    EXPECT_LT(baked->splits, soup->polygons.size() * 11 / 10) << name;
    // Each run of the mesh once, and the vertices of one meshlet at a time.
    std::size_t triangles = 0;
    EXPECT_TRUE(detail::for_each_bsp_run(baked->tree(), {0, 0, 65536, false}, baked->scene.mesh().triangles.size(),
                                         [&](std::uint32_t, std::uint32_t count) {
                                           triangles += count;
                                           return true;
                                         }));
    EXPECT_EQ(triangles, baked->scene.mesh().triangles.size()) << name;
    EXPECT_LE(count(baked->scene.scene()).largest_meshlet, 64U) << name;
  }
}

TEST(Visibility, AMeshIsDrawnByItsTreeWithoutDepth) {
  const View view{160, 120, PixelFormat::rgb565};
  for (const char* name : {"knot_meshlets", "random50"}) {
    scenes::Staged staged;
    scenes::stage_workload(*scenes::find(name), staged, 7);
    const Staging staging{staged.scene, staged.camera};
    int covered = 0;
    const int by_tree = wrong(staging, request("painter-bsp", view), &covered);
    EXPECT_LE(by_tree, covered / 1000) << name;  // corners of pieces are rounded to the grid
    EXPECT_GT(covered, 1000) << name;
    const LookedAtFrame frame = drawn(staging, request("painter-bsp", view));
    EXPECT_EQ(frame.plan.depth_bytes, 0U);
    EXPECT_LT(frame.plan.vertex_bytes, 4096U) << name;
  }
}

TEST(Visibility, TexturesAreRefusedBySplits) {
  scenes::Staged cube;
  scenes::stage_workload(*scenes::find("cube"), cube, 0);
  for (const char* method : {"painter-newell", "painter-bsp"}) {
    const Result<LookedAtFrame> frame = draw_looked_at({cube.scene, cube.camera}, request(method, kView));
    ASSERT_FALSE(frame);
    EXPECT_EQ(frame.failure().status, ExitStatus::usage);
    EXPECT_NE(frame.failure().message.find("textures"), std::string::npos);
  }
}

}  // namespace
}  // namespace zstrip::sim::test
