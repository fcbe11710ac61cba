// Scene blobs: what turns, the camera for it, and what the picture was baked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <tuple>

#include "bake/scene_blob.hpp"
#include "blob_sample.hpp"
#include "zstrip/blob.hpp"

namespace zstrip::sim::test {
namespace {

class SceneBlobTurn : public testing::Test {
 protected:
  static Opened with(Bytes bytes, std::uint32_t at, std::uint8_t value) {
    bytes[at] = value;
    mend(bytes);
    return Opened(bytes, scene_blob_memory(2, 2, 2));
  }
  static Status damaged(std::uint32_t at) { return {.error = Error::blob_damaged, .needed = at}; }

  const Bytes bytes_ = turn_bytes();
  const std::uint32_t turn_at_ = section(bytes_, "TURN"), camera_at_ = section(bytes_, "CAMT");
};

TEST_F(SceneBlobTurn, IsASectionBesideThatOfItsCamera) {
  EXPECT_EQ(word(bytes_, turn_at_), 0x00010002U);
  EXPECT_EQ(section_bytes(bytes_, "TURN"), 4U);
  EXPECT_EQ(section_bytes(bytes_, "CAMT"), 64U);
  const Opened opened(bytes_, scene_blob_memory(2, 2, 2));
  ASSERT_TRUE(opened.status) << message(opened.status.error) << ' ' << opened.status.needed;
  EXPECT_EQ(opened.content.turn, kTurn);
  EXPECT_EQ(opened.content.animation.duration, 0U);
  ASSERT_NE(opened.content.turning_camera, nullptr);
  EXPECT_EQ(reinterpret_cast<const std::byte*>(opened.content.turning_camera), opened.blob.bytes.get() + camera_at_);
  EXPECT_EQ(&opened.content.camera_for(1), &opened.content.camera);
  const Camera& turning = opened.content.camera_for(2);
  EXPECT_EQ(std::tuple(turning.right, turning.up, turning.back, turning.eye),
            std::tuple(kTurningCamera.right, kTurningCamera.up, kTurningCamera.back, kTurningCamera.eye));
  EXPECT_EQ(std::tuple(turning.focal, turning.near_plane, turning.far_plane, turning.projection),
            std::tuple(70000, kTurningCamera.near_plane, kTurningCamera.far_plane, Projection::perspective));
  EXPECT_TRUE(turning.fixed_depth_range);
}

TEST_F(SceneBlobTurn, WithoutItsSectionInstancesAndLinesTurn) {
  const Bytes without = lines_bytes();
  EXPECT_EQ(entry_of(without, "TURN") | entry_of(without, "CAMT") | entry_of(without, "ANIM"), 0U);
  const Opened opened(without, scene_blob_memory(2, 2, 2));
  ASSERT_TRUE(opened.status);
  EXPECT_EQ(opened.content.turn, Turn{});
  EXPECT_EQ(&opened.content.camera_for(2), &opened.content.camera);
  EXPECT_EQ(opened.content.effects, Effects{});
}

TEST_F(SceneBlobTurn, NeedsNoCamera) {
  SceneBlob content = sample();
  content.turn = {.what = Turning::camera};
  const Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(word(bytes, section(bytes, "TURN")), 0x00020000U);
  EXPECT_EQ(entry_of(bytes, "CAMT"), 0U);
  EXPECT_EQ(Opened(bytes).content.turn, content.turn);
}

TEST_F(SceneBlobTurn, IsNotThatOfAnAnimation) {
  constexpr Keyframe kStill[] = {
      {.time = 0, .rotation = {0, 0, 0, 32767}, .translation = {0, 0, 0}, .scale = {65536, 65536, 65536}}};
  constexpr Track kTracks[] = {{.instance = 0, .count = 1, .first = 0}};
  SceneBlob content = sample();
  content.animation = {.tracks = kTracks, .keyframes = kStill, .duration = 0x81010001};
  content.turn = kTurn;
  content.turning_camera = &kTurningCamera;
  const Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(section_bytes(bytes, "ANIM"), 4U);
  EXPECT_EQ(entry_of(bytes, "TURN") | entry_of(bytes, "CAMT"), 0U);
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status);
  EXPECT_EQ(opened.content.animation.duration, 0x81010001);
  EXPECT_EQ(opened.content.turn, Turn{});
  EXPECT_EQ(opened.content.turning_camera, nullptr);
}

TEST_F(SceneBlobTurn, ValuesThatAreNoneAreDamage) {
  EXPECT_TRUE(with(bytes_, turn_at_, 3).status) << "all three stand still";
  EXPECT_EQ(with(bytes_, turn_at_, 4).status, damaged(turn_at_)) << "there are three";
  EXPECT_EQ(with(bytes_, turn_at_ + 1, 1).status, damaged(turn_at_));
  EXPECT_TRUE(with(bytes_, turn_at_ + 2, 3).status);
  for (const int what : {4, 128, 255}) {
    EXPECT_EQ(with(bytes_, turn_at_ + 2, static_cast<std::uint8_t>(what)).status, damaged(turn_at_ + 2)) << what;
  }
  EXPECT_TRUE(with(bytes_, turn_at_ + 3, 255).status) << "unused";
  EXPECT_EQ(with(bytes_, camera_at_ + 60, 2).status, damaged(camera_at_ + 60)) << "projection";
  EXPECT_EQ(with(bytes_, camera_at_ + 61, 2).status, damaged(camera_at_ + 61)) << "fixed depth range";
  EXPECT_EQ(with(bytes_, camera_at_ + 51, 0x80).status.error, Error::camera) << "negative focal length";
  EXPECT_TRUE(with(bytes_, camera_at_ + 63, 9).status) << "unused";
}

TEST(SceneBlob, WhatThePictureWasBakedForStandsBesideItsFormat) {
  constexpr Effects kNumbers[] = {{},
                                  effect::perspective_affine,
                                  effect::perspective_8,
                                  effect::perspective_1,
                                  effect::depth_float,
                                  {},
                                  effect::depth_24};
  EXPECT_EQ(turn_bytes()[section(turn_bytes(), "PICT") + 7], 6) << "z24";
  Bytes bytes = sample_bytes();
  const std::uint32_t at = section(bytes, "PICT") + 7;
  for (std::uint32_t number = 0; number < 256; ++number) {
    bytes[at] = static_cast<std::uint8_t>(number);
    mend(bytes);
    const Opened opened(bytes);
    if (number == 5 || number == 7) {
      EXPECT_EQ(opened.status, (Status{.error = Error::blob_depth, .needed = number})) << "w16 and z32 are gone";
    } else if (number < std::size(kNumbers)) {
      SceneBlob content = sample();
      content.effects = kNumbers[number];
      EXPECT_EQ(*to_scene_blob(content), bytes) << number;
      ASSERT_TRUE(opened.status) << number;
      EXPECT_EQ(opened.content.effects, kNumbers[number]);
      EXPECT_EQ(opened.content.view.format, PixelFormat::gray4);
    } else {
      EXPECT_EQ(opened.status, (Status{.error = Error::blob_damaged, .needed = at})) << number;
    }
  }
}

}  // namespace
}  // namespace zstrip::sim::test
