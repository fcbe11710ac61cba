// How a frame is cut: bins and their overflow, meshlets that strips skip, and plans that do not belong to the scene.
#include <gtest/gtest.h>

#include <vector>

#include "picture.hpp"

namespace {

using namespace zstrip;
using namespace picture;

struct Drawn : Picture {
  Mode mode;
  std::uint32_t overflows;
};
Drawn draw_with_plan(const Scene& scene, const View& view, const Plan& p) {
  AnyRenderer renderer(effects_of(scene, Camera{}) | effect::statistics);
  Picture picture = draw(renderer, scene, Camera{}, view, p);
  EXPECT_TRUE(picture.status);
  return {std::move(picture), renderer.frame().mode(), renderer.frame().bin_overflows()};
}

TEST(Frame, BinsTransformOnceAndCountTheirOverflow) {
  Model model = random_model(11, 300, 2000);
  const Scene scene = model.scene();
  const View view{64, 64};
  const Effects effects = effects_of(scene, Camera{}) | effect::bins;
  const Plan p = plan(count(scene), view, effects, {.strip_rows = 4, .modes = Modes::binned}).plan;
  const Drawn binned = draw_with_plan(scene, view, p);
  EXPECT_EQ(binned.mode, Mode::binned);
  EXPECT_EQ(binned.overflows, 0U);
  EXPECT_EQ(binned.statistics.vertices, 900U);
  Plan tight = p;
  tight.bin_bytes = detail::rounded_up(kBatchBytes + p.strips * kBinBytes + 3 * kBinChunkBytes);
  const Drawn overflowed = draw_with_plan(scene, view, tight);
  EXPECT_EQ(overflowed.mode, Mode::streamed);
  EXPECT_EQ(overflowed.overflows, 1U);
  EXPECT_EQ(overflowed.pixels, binned.pixels);
  EXPECT_EQ(overflowed.statistics.drawn, binned.statistics.drawn);
}

/// Regression: bins were planned for half of the triangles though all of them could face, and overflowed.
TEST(Frame, BinsHoldTrianglesThatShowBothSides) {
  Model model = random_model(11, 300, 2000);
  model.material.double_sided = true;
  const Scene scene = model.scene();
  const View view{64, 64};
  const Effects effects = effects_of(scene, Camera{}) | effect::bins;
  ASSERT_TRUE(effects.has(effect::two_sided));
  const Budget budget{.strip_rows = 32, .modes = Modes::binned};
  const Drawn both = draw_with_plan(scene, view, plan(count(scene), view, effects, budget).plan);
  EXPECT_EQ(both.overflows, 0U);
  const Effects of_one_side{effects.bits & ~effect::two_sided.bits};
  const Drawn half = draw_with_plan(scene, view, plan(count(scene), view, of_one_side, budget).plan);
  EXPECT_EQ(half.overflows, 1U);
  EXPECT_EQ(half.pixels, both.pixels);
}

TEST(Frame, StripsVisitOnlyTheMeshletsThatTouchThem) {
  // Four meshlets in a column, a quarter of the picture each.
  Model model;
  std::vector<Meshlet> meshlets;
  for (std::uint16_t i = 0; i < 4; ++i) {
    const auto y = static_cast<std::int16_t>(24000 - 16000 * i);
    for (const Position p : {Position{-9000, static_cast<std::int16_t>(y - 2000), 0},
                             Position{9000, static_cast<std::int16_t>(y - 2000), 0},
                             Position{0, static_cast<std::int16_t>(y + 2000), 0}}) {
      model.positions.push_back(p);
    }
    const auto v = static_cast<std::uint16_t>(3 * i);
    model.triangles.push_back({v, static_cast<std::uint16_t>(v + 1), static_cast<std::uint16_t>(v + 2)});
    meshlets.push_back({i, v, 3, 1, 0, {}});
  }
  const Scene scene = model.scene();
  model.mesh.meshlets = meshlets;
  const View view{64, 64};
  const Effects effects = effects_of(scene, Camera{});
  const Drawn one = draw_with_plan(scene, view, plan(count(scene), view, effects).plan);
  EXPECT_EQ(one.statistics.vertices, 12U);
  const Drawn four = draw_with_plan(scene, view, plan(count(scene), view, effects, {.strip_rows = 16}).plan);
  EXPECT_EQ(four.statistics.drawn, 4U);
  EXPECT_EQ(four.statistics.vertices, 24U) << "once to see which strips they touch, once in the strip";
  EXPECT_EQ(four.pixels, one.pixels);
}

TEST(Frame, PlansOfOtherScenesAreRefused) {
  Model model = random_model(12, 30, 2000);
  const Scene scene = model.scene();
  const View view{64, 64};
  const Effects effects = effects_of(scene, Camera{}) | effect::bins;
  const Plan good =
      plan(count(scene), view, effects, {.strip_rows = 4, .strip_columns = 16, .modes = Modes::binned}).plan;
  std::vector<std::uint64_t> words(good.bytes() / 8 + 16);
  const auto arena = std::as_writable_bytes(std::span(words));
  AnyRenderer renderer(effects);
  ASSERT_TRUE(renderer.begin_frame(scene, Camera{}, view, good, arena));
  const auto refused = [&](auto change) {
    Plan bad = good;
    change(bad);
    return renderer.begin_frame(scene, Camera{}, view, bad, arena);
  };
  EXPECT_EQ(refused([](Plan& p) { p.extent_bytes = 0; }).purpose, Purpose::extents);
  EXPECT_EQ(refused([](Plan& p) { p.bin_bytes = kBatchBytes; }).purpose, Purpose::bins);
  EXPECT_EQ(refused([](Plan& p) { p.vertex_bytes = 64; }).purpose, Purpose::vertices);
  EXPECT_EQ(refused([](Plan& p) { p.strip_columns = 12; }).error, Error::strip_columns);
  EXPECT_EQ(refused([](Plan& p) { p.strip_columns = 72; }).error, Error::strip_columns);
  EXPECT_EQ(refused([](Plan& p) { p.strip_columns = 0; }).error, Error::strip_columns);
  EXPECT_EQ(refused([](Plan& p) { p.strip_columns = 8; }).error, Error::strip_rows);
  EXPECT_EQ(refused([](Plan& p) { ++p.strips; }).error, Error::strip_rows);
  Renderer<effect::vertex_colours | effect::gouraud | effect::lighting> without_bins;
  EXPECT_EQ(without_bins.begin_frame(scene, Camera{}, view, good, arena).error, Error::effect_missing);
}

TEST(Frame, ColoursThatNothingChangesTakeNoMemory) {
  Model model = random_model(14, 60, 9000);
  model.texels.clear();
  model.material.lit = false;
  const Scene scene = model.scene();
  const View view{64, 64};
  const Effects effects = effects_of(scene, Camera{}) | effect::bins;
  ASSERT_TRUE(effects.has(effect::vertex_colours));
  SceneCounts in_memory = count(scene);
  in_memory.colours_in_place = false;
  for (const Modes modes : {Modes::streamed, Modes::binned}) {
    const Budget budget{.strip_rows = 16, .modes = modes};
    const Plan in_place = plan(count(scene), view, effects, budget).plan;
    const Plan copied = plan(in_memory, view, effects, budget).plan;
    EXPECT_EQ(in_place.vertex_bytes * 12, copied.vertex_bytes * 8);
    EXPECT_EQ(draw_with_plan(scene, view, in_place).pixels, draw_with_plan(scene, view, copied).pixels);

    // A tint makes colours that need memory: of this plan it is refused.
    Model tinted = model;
    tinted.material.colour = {255, 200, 255, 255};
    std::vector<std::uint64_t> words(copied.bytes() / 8);
    AnyRenderer renderer(effects);
    const Status status =
        renderer.begin_frame(tinted.scene(), Camera{}, view, in_place, std::as_writable_bytes(std::span(words)));
    EXPECT_EQ(status.error, Error::arena_too_small);
    EXPECT_EQ(status.purpose, Purpose::vertices);
    EXPECT_TRUE(draw_with_plan(tinted.scene(), view, copied).status);
  }
}

// Regression: meshlets may share vertices, which bins keep once for each; the plan counted them once, and memory beyond
// the vertices was overwritten.
TEST(Frame, BinsHaveRoomForVerticesThatMeshletsShare) {
  Model model = random_model(13, 22, 20000);
  model.texels.clear();
  model.material.colour = {255, 255, 254, 255};  // or colours would be read in place
  model.triangles.resize(400, {0, 1, 2});
  model.positions[0] = {-20000, -20000, 0};
  model.positions[1] = {20000, -20000, 0};
  model.positions[2] = {0, 20000, 0};
  const Scene scene = model.scene();
  std::vector<Meshlet> meshlets;
  for (std::uint32_t i = 0; i < 400; ++i) meshlets.push_back({i, 0, 66, 1, 0, {}});
  model.mesh.meshlets = meshlets;
  ASSERT_TRUE(validate(scene));
  const View view{64, 64};
  const Effects effects = effects_of(scene, Camera{}) | effect::bins;
  const Plan p = plan(count(scene), view, effects, {.strip_rows = 32, .modes = Modes::binned}).plan;
  EXPECT_GE(p.vertex_bytes, 400U * 66 * 12);
  const Drawn binned = draw_with_plan(scene, view, p);
  EXPECT_EQ(binned.pixels,
            draw_with_plan(scene, view, plan(count(scene), view, effects, {.strip_rows = 32}).plan).pixels);
}

// Regression: a sum of vertices or meshlets beyond 32 bits wrapped, and a plan for the small rest was accepted.
TEST(Plan, CountsDoNotWrap) {
  std::vector<Position> positions(65535);
  const Triangle triangle{0, 1, 2};
  const std::vector<Meshlet> meshlets(65600, Meshlet{0, 0, 65535, 0, 0, {}});
  Mesh mesh;
  mesh.positions = positions;
  mesh.triangles = {&triangle, 1};
  mesh.meshlets = meshlets;
  const Material material;
  const Instance instances[2] = {};
  Scene scene;
  scene.meshes = {&mesh, 1};
  scene.materials = {&material, 1};
  scene.instances = instances;
  const SceneCounts counts = count(scene);
  EXPECT_EQ(counts.vertices, 0xFFFFFFFFU);
  EXPECT_EQ(counts.meshlets, 131200U);
  EXPECT_EQ(plan(counts, View{64, 64}, effect::bins, {.strip_rows = 8, .modes = Modes::binned}).status.error,
            Error::unplannable);
}

}  // namespace
