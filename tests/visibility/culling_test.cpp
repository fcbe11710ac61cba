// What culling leaves out is counted, may be switched off, and changes no pixel.
#include <algorithm>

#include "scenes.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::sim::test {
namespace {

constexpr View kView{96, 80, PixelFormat::rgb565};

/// `set` changes the options.
template <class Set>
MethodRequest culling(Effects own, const Set& set, std::uint16_t strip_rows = 0) {
  MethodRequest made = request("zbuffer", kView, strip_rows);
  made.effects = own | method::culling;
  set(made.options);
  return made;
}
void as_usual(VisibilityOptions&) {}

TEST(Visibility, CullingChangesNoPixelAndIsCounted) {
  scenes::Staged staged;
  scenes::stage_workload(*scenes::find("knot_meshlets"), staged, 3);
  const Staging staging{staged.scene, staged.camera};
  const LookedAtFrame usual = drawn(staging, culling({}, as_usual));
  EXPECT_GT(usual.visibility.back_faces, 1500U);
  EXPECT_GT(usual.visibility.small, 10U);
  EXPECT_EQ(usual.statistics.drawn + usual.visibility.back_faces + usual.visibility.small, usual.statistics.triangles);
  // A closed surface: nearer front faces hide all back faces.
  const LookedAtFrame both = drawn(staging, culling({}, [](VisibilityOptions& o) { o.cull_back_faces = false; }));
  EXPECT_EQ(both.pixels, usual.pixels);
  EXPECT_EQ(both.visibility.back_faces, 0U);
  EXPECT_GT(both.statistics.fragments, usual.statistics.fragments * 3 / 2);
  const LookedAtFrame small = drawn(staging, culling({}, [](VisibilityOptions& o) { o.cull_small = false; }));
  EXPECT_EQ(small.pixels, usual.pixels);
  EXPECT_GT(small.statistics.drawn, usual.statistics.drawn);
}

TEST(Visibility, SpheresLeaveOutMeshletsBesideThePicture) {
  scenes::Staged staged;
  scenes::stage_workload(*scenes::find("knot_meshlets"), staged, 3);
  staged.camera.focal *= 4;
  const Staging staging{staged.scene, staged.camera};
  for (const std::uint16_t rows : std::initializer_list<std::uint16_t>{80, 16}) {
    const LookedAtFrame all = drawn(staging, culling({}, as_usual, rows));
    const LookedAtFrame fewer = drawn(staging, culling(
                                                   {}, [](VisibilityOptions& o) { o.cull_by_spheres = true; }, rows));
    EXPECT_EQ(all.pixels, fewer.pixels);
    EXPECT_GT(fewer.visibility.outside, 50U);
    EXPECT_LT(fewer.statistics.vertices, all.statistics.vertices);
  }
}

TEST(Visibility, APotentiallyVisibleSetLeavesOutTheRest) {
  scenes::Staged staged;
  scenes::stage_workload(*scenes::find("knot_meshlets"), staged, 3);
  const Staging staging{staged.scene, staged.camera};
  const std::vector<std::uint32_t> every(2, UINT32_MAX), none(2, 0);
  const LookedAtFrame all = drawn(staging, culling({}, [&](VisibilityOptions& o) { o.potentially_visible = every; }));
  EXPECT_EQ(all.pixels, drawn(staging, culling({}, as_usual)).pixels);
  const LookedAtFrame nothing =
      drawn(staging, culling({}, [&](VisibilityOptions& o) { o.potentially_visible = none; }));
  EXPECT_EQ(nothing.visibility.outside_cells, nothing.statistics.triangles);
  EXPECT_EQ(nothing.statistics.fragments, 0U);
  const std::vector<std::uint32_t> half{UINT32_MAX, 0};
  for (const Effects own : {Effects{}, method::painter, method::hierarchical_z}) {
    const LookedAtFrame some =
        drawn(staging, culling(
                           own, [&](VisibilityOptions& o) { o.potentially_visible = half; }, 24));
    EXPECT_GT(some.statistics.fragments, 0U);
    EXPECT_LT(some.statistics.drawn, all.statistics.drawn);
  }
}

TEST(Visibility, WhatWasSeenBeforeHidesTheRestSooner) {
  scenes::Staged staged;
  scenes::stage_workload(*scenes::find("knot_meshlets"), staged, 3);
  const Staging staging{staged.scene, staged.camera};
  const LookedAtFrame plain = drawn(staging, request("hierarchical-z", kView));
  const std::uint32_t words = seen_words(count(staged.scene).meshlets);
  ASSERT_EQ(words, 4U);
  std::vector<std::uint32_t> seen(words, 0);
  const LookedAtFrame first =
      drawn(staging, culling(method::hierarchical_z, [&](VisibilityOptions& o) { o.seen_before = seen; }));
  EXPECT_EQ(first.pixels, plain.pixels);
  EXPECT_EQ(first.visibility.drawn_first, 0U);
  EXPECT_EQ(seen[0] | seen[1], 0U);
  EXPECT_NE(seen[2] | seen[3], 0U);
  scenes::stage_workload(*scenes::find("knot_meshlets"), staged, 4);
  const Staging next{staged.scene, staged.camera};
  const LookedAtFrame second =
      drawn(next, culling(method::hierarchical_z, [&](VisibilityOptions& o) { o.seen_before = seen; }));
  EXPECT_EQ(second.depth, drawn(next, request("hierarchical-z", kView)).depth);
  EXPECT_GT(second.visibility.drawn_first, 10U);
  // Any bits are right.
  for (const std::uint32_t bits : {0x12345678U, 0xFFFFFFFFU}) {
    std::vector<std::uint32_t> any(words, bits);
    EXPECT_EQ(drawn(next, culling(
                              method::hierarchical_z, [&](VisibilityOptions& o) { o.seen_before = any; }, 16))
                  .depth,
              second.depth);
  }
}

TEST(Visibility, WhatIsSwitchedOffIsNotCounted) {
  scenes::Staged staged;
  scenes::stage_workload(*scenes::find("knot_meshlets"), staged, 3);
  const Staging staging{staged.scene, staged.camera};
  const VisibilityStatistics nothing = drawn(staging, culling({},
                                                              [](VisibilityOptions& o) {
                                                                o.cull_back_faces = false;
                                                                o.cull_small = false;
                                                              }))
                                           .visibility;
  EXPECT_EQ(nothing.back_faces, 0U);
  EXPECT_EQ(nothing.small, 0U);
  EXPECT_EQ(nothing.outside, 0U);
  EXPECT_EQ(nothing.outside_cells, 0U);
  const VisibilityStatistics small =
      drawn(staging, culling({}, [](VisibilityOptions& o) { o.cull_back_faces = false; })).visibility;
  EXPECT_EQ(small.back_faces, 0U);
  EXPECT_GT(small.small, 10U);
}

/// Knots one behind another that turn and come nearer; one comes into the picture.
TEST(Visibility, TemporalCoherenceChangesNoPixelOfAnAnimation) {
  scenes::Staged staged;
  scenes::stage_workload(*scenes::find("knot_meshlets"), staged, 0);
  const Instance knot = staged.scene.instances[0];
  std::vector<Instance> instances;
  const std::uint32_t per_knot = count(staged.scene).meshlets;
  std::vector<std::uint32_t> seen(seen_words(3 * per_knot), 0);
  std::uint32_t drawn_first = 0, writes = 0, writes_without = 0;
  for (std::uint32_t frame = 0; frame < 12; ++frame) {
    // The one behind is listed first, the one before last; from frame 6 on there is a third between them.
    instances = {knot, knot};
    instances[0].transform.m[2][3] -= 2 * kFixedOne;
    if (frame >= 6) instances.insert(instances.begin() + 1, knot);
    for (std::size_t i = 0; i < instances.size(); ++i) {
      instances[i].transform = scenes::turned(instances[i].transform, frame + static_cast<std::uint32_t>(i), 48);
    }
    if (frame >= 6) instances[1].transform.m[0][3] += kFixedOne / 4;
    Scene scene = staged.scene;
    scene.instances = instances;
    Camera camera = staged.camera;
    camera.eye.z -= static_cast<Fixed>(frame) * kFixedOne / 24;
    const Staging staging{scene, camera};
    for (const std::uint16_t rows : std::initializer_list<std::uint16_t>{80, 16}) {
      const LookedAtFrame plain = drawn(staging, request("zbuffer", kView, rows));
      const LookedAtFrame without = drawn(staging, request("hierarchical-z", kView, rows));
      const LookedAtFrame coherent =
          drawn(staging, culling(
                             method::hierarchical_z, [&](VisibilityOptions& o) { o.seen_before = seen; }, rows));
      EXPECT_EQ(plain.depth, coherent.depth) << frame;
      EXPECT_EQ(plain.pixels, coherent.pixels) << frame;
      if (rows != 16) continue;
      drawn_first += coherent.visibility.drawn_first;
      writes += coherent.visibility.writes;
      writes_without += without.visibility.writes;
    }
  }
  EXPECT_GT(drawn_first, 100U);
  EXPECT_LT(writes, writes_without);
}

}  // namespace
}  // namespace zstrip::sim::test
