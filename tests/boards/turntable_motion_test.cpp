// Motions of boards' programs have constants for scene and picture, and leave clipping out where the scene stays in
// front of the camera: all their frames are drawn, and are those of any renderer.
#include "portable/turntable_motion.hpp"

#include <gtest/gtest.h>

#include <array>

#include "portable/checksum_panel.hpp"
#include "portable/scene_player.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/random.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/spheres.hpp"
#include "zstrip_scenes/teapot.hpp"
#include "zstrip_scenes/teapot_meshlets.hpp"
#include "zstrip_scenes/terrain.hpp"
#include "zstrip_scenes/triangle.hpp"
#include "zstrip_scenes/wires.hpp"

namespace zstrip::board::test {
namespace {

constexpr Budget kBudget{.bytes = 256 * 1024, .split_columns = true, .strip_buffers = 1};

/// The same turn as any renderer draws it: scene, picture and plan are checked when it runs, and it clips.
template <const scenes::BuiltIn& scene, View view>
struct AnyTurn {
  static constexpr View kView = view;
  static constexpr std::uint32_t kFrames = 64;
  static constexpr Effects kEffects = effects_of(scene.scene, scene.camera);
  static constexpr Plan kPlan = plan(scene.counts, view, kEffects, kBudget).plan;
  static Status move_to(std::uint32_t frame) {
    scenes::stage(scene, staged, frame, kFrames, view);
    return {};
  }
  static Status begin_frame() { return renderer.begin_frame(staged.scene, staged.camera, view, kPlan, arena); }
  static Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    return renderer.draw_strip(strip, pixels);
  }
  static inline scenes::Staged staged;
  static inline Renderer<kEffects> renderer;
  alignas(kArenaAlignment) static inline std::array<std::byte, kPlan.bytes()> arena;
};

template <class Motion>
constexpr bool kClips = !Motion::Drawing::kEffects.has(effect::unclipped);

/// The whole loop of a program, as its player shows it.
template <const scenes::BuiltIn& scene, std::uint16_t width, std::uint16_t height, bool clips = false>
void expect_whole_loop() {
  constexpr View kView{width, height, PixelFormat::rgb565_swapped};
  using Motion = TurntableMotion<scene, kView, kBudget>;
  static_assert(kClips<Motion> == clips);
  ChecksumPanel<width, height> panel, other;
  for (std::uint32_t frame = 0; frame < Motion::kFrames; ++frame) {
    const Failure failure = ScenePlayer<Motion>::show(panel, frame);
    ASSERT_FALSE(failure) << scene.name << ' ' << frame << ": " << failure.error;
    ASSERT_FALSE((ScenePlayer<AnyTurn<scene, kView>>::show(other, frame)));
    ASSERT_EQ(panel.crc32(), other.crc32()) << scene.name << ' ' << frame;
  }
}

TEST(TurntableMotion, WholeLoopsOfBoardsAreThoseOfAnyRenderer) {
  expect_whole_loop<scenes::teapot, 128, 64>();
  expect_whole_loop<scenes::teapot, 320, 240>();
  expect_whole_loop<scenes::teapot_meshlets, 128, 128>();
  expect_whole_loop<scenes::teapot_meshlets, 240, 240>();
  expect_whole_loop<scenes::knot_textured, 240, 240>();
  expect_whole_loop<scenes::room, 128, 128, true>();
  expect_whole_loop<scenes::room, 640, 480, true>();
}

/// What the ball around a scene promises.
template <const scenes::BuiltIn& scene>
void expect_whole_turn() {
  const auto expect = []<View view>() {
    constexpr std::uint32_t kPoses = 4096;
    using Motion = TurntableMotion<scene, view, kBudget, kPoses>;
    static_assert(!kClips<Motion>);
    for (std::uint32_t pose = 0; pose < kPoses; ++pose) {
      ASSERT_TRUE(Motion::move_to(pose));
      const Status begun = Motion::begin_frame();
      ASSERT_TRUE(begun) << scene.name << ' ' << view.width << ' ' << pose << ": " << message(begun.error);
    }
  };
  expect.template operator()<View{16, 9}>();
  expect.template operator()<View{640, 480}>();
}

TEST(TurntableMotion, WhatStaysInFrontIsNeverRefused) {
  expect_whole_turn<scenes::triangle>();
  expect_whole_turn<scenes::cube>();
  expect_whole_turn<scenes::teapot>();
  expect_whole_turn<scenes::knot_textured>();
  expect_whole_turn<scenes::random50>();
  expect_whole_turn<scenes::wires>();
  expect_whole_turn<scenes::spheres>();
}

constexpr scenes::BuiltIn kNearTeapot = [] {
  scenes::BuiltIn scene = scenes::teapot;
  scene.camera = scenes::turntable_camera(1.4, 20, 2);
  return scene;
}();
constexpr scenes::BuiltIn kShortTeapot = [] {
  scenes::BuiltIn scene = scenes::teapot;
  scene.camera.far_plane = fixed(5);
  return scene;
}();

TEST(TurntableMotion, ClipsWhatTheCameraMayEnterOrLose) {
  constexpr View kQvga{320, 240};
  static_assert(kClips<TurntableMotion<scenes::room, kQvga, kBudget>>);
  static_assert(kClips<TurntableMotion<scenes::terrain, kQvga, kBudget>>);
  static_assert(kClips<TurntableMotion<kNearTeapot, kQvga, kBudget>>);
  static_assert(kClips<TurntableMotion<kShortTeapot, kQvga, kBudget>>);
  static_assert(!kClips<TurntableMotion<scenes::teapot, kQvga, kBudget>>);
  static_assert(!scenes::stays_in_front(scenes::teapot, {2048, 2048}), "more than a thousand pixels from the centre");
}

/// A program that moves nearer than the motion says gets words, not a wrong picture.
struct Closing : TurntableMotion<scenes::teapot, View{128, 96, PixelFormat::rgb565_swapped}, kBudget> {
  static Status move_to(std::uint32_t frame) {
    near = scenes::fitted_camera(scenes::teapot, kView);
    if (frame == 1) near.eye = {near.eye.x / 8, near.eye.y / 8, near.eye.z / 8};
    return {};
  }
  static Status begin_frame() { return renderer.begin_frame(near, moving); }
  static inline Camera near;
};

TEST(TurntableMotion, AFrameThatWouldBeClippedIsSaidInWords) {
  ChecksumPanel<128, 96> panel;
  EXPECT_FALSE(ScenePlayer<Closing>::show(panel, 0));
  const Failure failure = ScenePlayer<Closing>::show(panel, 1);
  EXPECT_STREQ(failure.doing, "begin of the frame");
  EXPECT_STREQ(failure.error, "an instance comes too close to the camera for a renderer without clipping");
  EXPECT_FALSE(ScenePlayer<Closing>::show(panel, 2)) << "the next one is drawn again";
}

}  // namespace
}  // namespace zstrip::board::test
