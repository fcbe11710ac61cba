// Each method's picture against the judge and against the z-buffer's, streamed, binned and in strips.
#include "../oracle/draw.hpp"
#include "scenes.hpp"
#include "zstrip/zstrip.hpp"

namespace zstrip::sim::test {
namespace {

constexpr View kView{96, 80, PixelFormat::rgb565};

/// A frame of a built-in scene's workload, which has triangles of all kinds.
struct Workload {
  explicit Workload(const char* name) { scenes::stage_workload(*scenes::find(name), staged, 7); }
  Staging staging() const { return {staged.scene, staged.camera}; }
  scenes::Staged staged;
};

TEST(Visibility, TheZBufferAndWhatKeepsItsPromiseHaveNoWrongPixel) {
  const Workload knot("knot_meshlets"), random("random50");
  for (const char* method :
       {"zbuffer", "front-to-back", "hierarchical-z", "front-to-back-hierarchical-z", "midpoint-safe"}) {
    for (const Workload* workload : {&knot, &random}) {
      int covered = 0;
      EXPECT_EQ(wrong(workload->staging(), request(method, kView), &covered), 0) << method;
      EXPECT_GT(covered, 500);
    }
  }
}

TEST(Visibility, TheJudgeFindsWhatIsDrawnInTheWrongOrder) {
  const Workload random("random50");
  EXPECT_GT(wrong(random.staging(), request("painter", kView)), 20);
}

TEST(Visibility, ThePainterHasNoDepthMemory) {
  const Workload random("random50");
  const LookedAtFrame sorted = drawn(random.staging(), request("painter", kView));
  EXPECT_EQ(sorted.plan.depth_bytes, 0U);
  EXPECT_EQ(sorted.plan.visibility_bytes, 50U * 16);
  EXPECT_EQ(sorted.visibility.comparisons, 0U);
  EXPECT_EQ(sorted.visibility.writes, sorted.statistics.fragments);
  EXPECT_EQ(drawn(random.staging(), request("painter-newell", kView)).plan.visibility_bytes, 0U);
}

// Where two fragments of a pixel have the same code, the first one drawn stays: only there may an order be seen.
TEST(Visibility, HierarchicalZAndMidpointSafeDrawTheZBuffersPixels) {
  for (const char* scene : {"knot_meshlets", "random50", "cube", "room"}) {
    const Workload workload(scene);
    for (const std::uint16_t rows : std::initializer_list<std::uint16_t>{80, 24, 7}) {
      const LookedAtFrame plain = drawn(workload.staging(), request("zbuffer", kView, rows));
      const LookedAtFrame bounded = drawn(workload.staging(), request("hierarchical-z", kView, rows));
      EXPECT_EQ(plain.pixels, bounded.pixels) << scene << ' ' << rows;
      EXPECT_EQ(plain.depth, bounded.depth) << scene << ' ' << rows;
      for (const std::uint8_t iterations : std::initializer_list<std::uint8_t>{0, 3}) {
        MethodRequest safe = request("midpoint-safe", kView, rows);
        safe.options.iterations = iterations;
        const LookedAtFrame split = drawn(workload.staging(), safe);
        EXPECT_EQ(plain.depth, split.depth) << scene << ' ' << rows;
        EXPECT_EQ(plain.pixels, split.pixels) << scene << ' ' << rows;
      }
    }
  }
}

TEST(Visibility, EveryMethodDrawsTheSameInStripsAndBins) {
  for (const char* method : {"painter", "front-to-back", "hierarchical-z", "front-to-back-hierarchical-z",
                             "midpoint-safe", "painter-newell", "painter-bsp"}) {
    for (const char* scene : {"random50", "knot_meshlets"}) {
      if (std::string_view(method).starts_with("painter-") && std::string_view(scene) != "random50") continue;
      const Workload workload(scene);
      const LookedAtFrame whole = drawn(workload.staging(), request(method, kView));
      EXPECT_GT(whole.visibility.writes, 500U) << method;
      for (const std::uint16_t rows : std::initializer_list<std::uint16_t>{1, 13, 40}) {
        MethodRequest strips = request(method, kView, rows);
        EXPECT_EQ(whole.pixels, drawn(workload.staging(), strips).pixels) << method << ' ' << scene << ' ' << rows;
        strips.budget.modes = Modes::binned;
        strips.budget.strip_columns = 32;
        const LookedAtFrame binned = drawn(workload.staging(), strips);
        EXPECT_EQ(whole.pixels, binned.pixels) << method << ' ' << scene << " binned " << rows;
      }
    }
  }
}

TEST(Visibility, FrontToBackWritesOnceAndHierarchicalZComparesLess) {
  const View view{384, 320, PixelFormat::rgb565};  // most tiles lie inside the triangles
  std::vector<Corners> layers;                     // the nearest one last
  for (int i = 0; i < 12; ++i) layers.push_back({{{0, 0, i / 4.0 - 4}, {6, 0, i / 4.0 - 4}, {3, 6, i / 4.0 - 4}}});
  const SoupScene scene = scene_of(layers);
  const Staging staging{scene.scene(), camera_at(Projection::orthographic)};
  const LookedAtFrame front = drawn(staging, request("front-to-back", view));
  const LookedAtFrame bounded = drawn(staging, request("front-to-back-hierarchical-z", view));
  MethodRequest counted = request("zbuffer", view);
  counted.effects = method::culling;
  const LookedAtFrame plain = drawn(staging, counted);
  EXPECT_EQ(plain.visibility.comparisons, plain.statistics.fragments);
  EXPECT_EQ(plain.visibility.writes, plain.statistics.fragments);
  EXPECT_EQ(front.visibility.comparisons, plain.statistics.fragments);
  EXPECT_EQ(front.visibility.writes, plain.statistics.fragments / 12);
  EXPECT_LT(bounded.visibility.comparisons, front.visibility.comparisons / 2);
  EXPECT_EQ(bounded.pixels, plain.pixels);
  std::uint64_t overdraw = 0;
  for (const std::uint8_t times : plain.overdraw) overdraw += times;
  EXPECT_EQ(overdraw, plain.visibility.writes);
}

TEST(Visibility, PipelinesWithoutCountsDrawTheSame) {
  for (const char* scene : {"random50", "knot_meshlets"}) {
    const Workload workload(scene);
    const Effects of_scene = effects_of(workload.staged.scene, workload.staged.camera);
    for (const char* name : {"zbuffer", "painter", "front-to-back", "hierarchical-z", "front-to-back-hierarchical-z",
                             "midpoint", "midpoint-safe"}) {
      const LookedAtFrame counted = drawn(workload.staging(), request(name, kView, 80));
      const Effects effects = of_scene | parse_visibility(std::string(name))->effects;
      const Pipeline pipeline = pipeline_for(effects);
      detail::MethodFrameState state;
      const FrameWithMethod frame(state);
      std::vector<std::uint64_t> arena(counted.plan.bytes() / 8 + 1);
      std::vector<std::uint16_t> pixels(counted.pixels.size());
      ASSERT_TRUE(pipeline.begin_frame(state, workload.staged.scene, workload.staged.camera, kView, counted.plan,
                                       std::as_writable_bytes(std::span(arena))));
      ASSERT_TRUE(pipeline.draw_strip(state, 0, std::as_writable_bytes(std::span(pixels))));
      EXPECT_EQ(pixels, counted.pixels) << scene << ' ' << name;
      EXPECT_EQ(frame.visibility().comparisons, 0U);
      EXPECT_EQ(frame.statistics().fragments, 0U);
    }
  }
}

TEST(Visibility, MoreIterationsOfMidpointLeaveFewerWrongPixels) {
  const Workload workload("random50");
  int first = 0, last = INT32_MAX;
  for (const std::uint8_t iterations : std::initializer_list<std::uint8_t>{0, 2, 4, 6}) {
    MethodRequest midpoint = request("midpoint", kView);
    midpoint.options.iterations = iterations;
    const int now = wrong(workload.staging(), midpoint);
    EXPECT_LE(now, last) << int{iterations};
    if (last == INT32_MAX) first = now;
    last = now;
  }
  EXPECT_LT(last, first);
  EXPECT_GT(last, 0);  // the method's own fault, not the judge's
}

TEST(Visibility, BothProjectionsHaveEveryMethod) {
  const SoupScene scene = scene_of(thesis_polygons());
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    for (const VisibilityMethod& method : visibility_methods()) {
      const LookedAtFrame frame = drawn({scene.scene(), camera_at(projection)}, request(method.name, kView));
      EXPECT_GT(frame.statistics.fragments, 100U) << method.name;
    }
  }
}

TEST(Visibility, WhatAMethodCannotIsRefused) {
  EXPECT_FALSE(methods_agree(method::painter | method::front_to_back));
  EXPECT_FALSE(methods_agree(method::painter | method::hierarchical_z));
  EXPECT_FALSE(methods_agree(method::hierarchical_z | method::midpoint));
  EXPECT_FALSE(methods_agree(method::bsp | method::front_to_back));
  EXPECT_FALSE(methods_agree(method::painter | effect::depth_float));
  EXPECT_FALSE(methods_agree(method::front_to_back | effect::depth_state));
  EXPECT_TRUE(methods_agree(method::hierarchical_z | effect::depth_state));
  EXPECT_TRUE(methods_agree(method::culling | effect::depth_state));
  const Workload workload("random50");
  const Effects effects = effects_of(workload.staged.scene, workload.staged.camera) | effect::bins;
  EXPECT_EQ(plan(count(workload.staged.scene), kView, effects | method::painter | method::midpoint, {}).status.error,
            Error::visibility);
  // A painter without its tree, and draw_over with any method.
  const PlanResult planned = plan(count(workload.staged.scene), kView, effects | method::painter | method::bsp, {});
  ASSERT_TRUE(planned.status);
  AnyRenderer renderer(effects | method::painter | method::bsp);
  EXPECT_EQ(picture::begun(renderer, workload.staged.scene, workload.staged.camera, kView, planned.plan).error,
            Error::visibility);
  std::vector<std::byte> pixels(planned.plan.strip_pixel_bytes(kView));
  EXPECT_EQ(renderer.draw_strip(0, pixels).error, Error::not_begun);
}

TEST(Visibility, MemoryIsPlannedAndTooLittleIsRefused) {
  const Workload workload("random50");
  const Effects effects =
      effects_of(workload.staged.scene, workload.staged.camera) | effect::bins | method::front_to_back;
  const SceneCounts counts = count(workload.staged.scene);
  const PlanResult planned = plan(counts, kView, effects, {.strip_rows = 80, .modes = Modes::streamed});
  ASSERT_TRUE(planned.status);
  EXPECT_EQ(planned.plan.visibility_bytes, 50U * 16);
  Plan less = planned.plan;
  less.visibility_bytes -= 8;
  const Status status =
      picture::begun(AnyRenderer(effects), workload.staged.scene, workload.staged.camera, kView, less);
  EXPECT_EQ(status.error, Error::arena_too_small);
  EXPECT_EQ(status.purpose, Purpose::sorting);
  EXPECT_EQ(status.needed, 50U * 16);
  // Tiles of 12x10, and nodes of 6x5, 3x3, 2x2, 1.
  const Effects bounded = effects_of(workload.staged.scene, workload.staged.camera) | method::hierarchical_z;
  EXPECT_EQ(plan(counts, kView, bounded, {.strip_rows = 80}).plan.visibility_bytes,
            (120U * 6 + (30 + 9 + 4 + 1) * 2 + 7) / 8 * 8);
}

}  // namespace
}  // namespace zstrip::sim::test
