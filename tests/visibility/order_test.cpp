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
  const auto visit = [](std::uint32_t, std::uint32_t) { return true; };
  const auto order = [&](const std::vector<BspNode>& nodes) {
    return detail::for_each_bsp_run({nodes, 1}, eye, 4, visit);
  };
  BspNode node{};
  node.z = 1 << 30;
  node.triangle_count = 4;
  EXPECT_TRUE(order({}));
  EXPECT_TRUE(order({node}));
  BspNode beyond = node;
  beyond.triangle_count = 5;
  EXPECT_FALSE(order({beyond}));
  beyond = node;
  beyond.first_triangle = UINT32_MAX;
  EXPECT_FALSE(order({beyond}));
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
  child.front = 0;
  child.back = 1;  // itself
  EXPECT_FALSE(order({parent, child}));
  // Two parents of one child, over and over: more visits than nodes.
  std::vector<BspNode> shared(20, node);
  for (std::uint32_t i = 0; i + 1 < shared.size(); ++i) shared[i].front = shared[i].back = i + 1;
  EXPECT_FALSE(order(shared));
  // Deeper than the stack.
  std::vector<BspNode> deep(kMostBspDepth + 1, node);
  for (std::uint32_t i = 0; i + 1 < deep.size(); ++i) deep[i].back = i + 1;
  EXPECT_FALSE(order(deep));
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
