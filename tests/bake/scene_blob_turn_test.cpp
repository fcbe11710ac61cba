// Scene blobs: what turns, the camera for it, and what the picture was baked for, in bytes that older blobs leave 0.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <tuple>

#include "bake/scene_blob.hpp"
#include "blob_sample.hpp"
#include "zstrip/scene/scene_blob.hpp"

namespace zstrip::sim::test {
namespace {

constexpr std::uint32_t kTurnAt = 148, kFormatAt = 128;
constexpr std::uint32_t kCameraAt = 192 + 8 + 12 + 2 * 64;  // behind the header, an outline, the shadow, two sets

class SceneBlobTurn : public testing::Test {
 protected:
  static Opened with(Bytes bytes, std::uint32_t at, std::uint8_t value) {
    bytes[at] = value;
    mend(bytes);
    return Opened(bytes, scene_blob_memory(2, 2, 2));
  }
  static Status damaged(std::uint32_t at) { return {.error = Error::blob_damaged, .needed = at}; }

  const Bytes bytes_ = turn_bytes();
};

TEST_F(SceneBlobTurn, StandsWhereAnAnimationWouldHaveItsDuration) {
  EXPECT_EQ(bytes_[2], 3) << "the version stays";
  EXPECT_EQ(word(bytes_, kTurnAt), 0x81010002U);
  EXPECT_EQ(word(bytes_, 12), kCameraAt + 64) << "then the meshes";
  const Opened opened(bytes_, scene_blob_memory(2, 2, 2));
  ASSERT_TRUE(opened.status) << message(opened.status.error) << ' ' << opened.status.needed;
  EXPECT_EQ(opened.content.turn, kTurn);
  EXPECT_EQ(opened.content.animation.duration, 0U);
  ASSERT_NE(opened.content.turning_camera, nullptr);
  EXPECT_EQ(reinterpret_cast<const std::byte*>(opened.content.turning_camera), opened.blob.bytes.get() + kCameraAt);
  EXPECT_EQ(&opened.content.camera_for(1), &opened.content.camera);
  const Camera& turning = opened.content.camera_for(2);
  EXPECT_EQ(std::tuple(turning.right, turning.up, turning.back, turning.eye),
            std::tuple(kTurningCamera.right, kTurningCamera.up, kTurningCamera.back, kTurningCamera.eye));
  EXPECT_EQ(std::tuple(turning.focal, turning.near_plane, turning.far_plane, turning.projection),
            std::tuple(70000, kTurningCamera.near_plane, kTurningCamera.far_plane, Projection::perspective));
  EXPECT_TRUE(turning.fixed_depth_range);
}

TEST_F(SceneBlobTurn, OfOlderBlobsIsOfInstancesAndLines) {
  const Bytes older = lines_bytes();
  EXPECT_EQ(word(older, kTurnAt), 0U);
  // Some have the duration of an animation that moves no instance.
  for (const std::uint32_t duration : {0U, 3200U, 0x7FFFFFFFU}) {
    Bytes bytes = older;
    put_word(bytes, kTurnAt, duration);
    mend(bytes);
    const Opened opened(bytes, scene_blob_memory(2, 2, 2));
    ASSERT_TRUE(opened.status) << duration;
    EXPECT_EQ(opened.content.turn, Turn{});
    EXPECT_EQ(&opened.content.camera_for(2), &opened.content.camera);
    EXPECT_EQ(opened.content.effects, Effects{});
  }
}

TEST_F(SceneBlobTurn, NeedsNoCamera) {
  SceneBlob content = sample();
  content.turn = {.what = Turning::camera};
  const Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(word(bytes, kTurnAt), 0x80020000U);
  EXPECT_EQ(word(bytes, 12), 192U) << "no record behind the header";
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
  const Opened opened(*to_scene_blob(content));
  ASSERT_TRUE(opened.status);
  EXPECT_EQ(opened.content.animation.duration, 0x81010001);
  EXPECT_EQ(opened.content.turn, Turn{});
  EXPECT_EQ(opened.content.turning_camera, nullptr);
}

TEST_F(SceneBlobTurn, ValuesThatAreNoneAreDamage) {
  EXPECT_TRUE(with(bytes_, kTurnAt, 3).status) << "all three stand still";
  EXPECT_EQ(with(bytes_, kTurnAt, 4).status, damaged(kTurnAt)) << "there are three";
  EXPECT_EQ(with(bytes_, kTurnAt + 1, 1).status, damaged(kTurnAt));
  EXPECT_TRUE(with(bytes_, kTurnAt + 2, 3).status);
  for (const int what : {4, 128, 255}) {
    EXPECT_EQ(with(bytes_, kTurnAt + 2, static_cast<std::uint8_t>(what)).status, damaged(kTurnAt + 2)) << what;
  }
  for (const int has : {0x82, 0xC1, 0xFF}) {
    EXPECT_EQ(with(bytes_, kTurnAt + 3, static_cast<std::uint8_t>(has)).status, damaged(kTurnAt + 3)) << has;
  }
  EXPECT_EQ(with(bytes_, kTurnAt + 3, 0x80).content.turning_camera, nullptr);
  EXPECT_EQ(with(bytes_, kCameraAt + 60, 2).status, damaged(kCameraAt + 60)) << "projection";
  EXPECT_EQ(with(bytes_, kCameraAt + 61, 2).status, damaged(kCameraAt + 61)) << "fixed depth range";
  EXPECT_EQ(with(bytes_, kCameraAt + 51, 0x80).status.error, Error::camera) << "negative focal length";
  EXPECT_TRUE(with(bytes_, kCameraAt + 63, 9).status) << "unused";
}

TEST_F(SceneBlobTurn, ACameraBeyondTheEndIsDamage) {
  const Bytes whole = sample_bytes();
  Bytes bytes(whole.begin(), whole.begin() + 192);
  for (const std::uint32_t array : {12U, 20U, 28U, 36U, 44U, 152U, 160U, 168U}) {
    put_word(bytes, array, 0);
    put_word(bytes, array + 4, 0);
  }
  put_word(bytes, kTurnAt, 0x81030000);
  for (const std::size_t room : {0U, 4U, 60U, 63U}) {
    bytes.resize(192 + room);
    mend(bytes);
    EXPECT_EQ(Opened(bytes).status, damaged(kTurnAt + 3)) << room;
  }
}

TEST(SceneBlob, WhatThePictureWasBakedForStandsBesideItsFormat) {
  EXPECT_EQ(turn_bytes()[kFormatAt], 0x60 | 2) << "z24, gray4";
  EXPECT_EQ(sample_bytes()[kFormatAt], 2) << "as before there was anything else";
  constexpr Effects kNumbers[] = {{},
                                  effect::perspective_affine,
                                  effect::perspective_8,
                                  effect::perspective_1,
                                  effect::depth_float,
                                  effect::depth_w16,
                                  effect::depth_24,
                                  effect::depth_32};
  Bytes bytes = sample_bytes();
  for (std::uint32_t number = 0; number < 16; ++number) {
    SceneBlob content = sample();
    if (number < std::size(kNumbers)) content.effects = kNumbers[number];
    bytes[kFormatAt] = static_cast<std::uint8_t>(number << 4 | 2);
    mend(bytes);
    const Opened opened(bytes);
    if (number < std::size(kNumbers)) {
      EXPECT_EQ(*to_scene_blob(content), bytes) << number;
      ASSERT_TRUE(opened.status) << number;
      EXPECT_EQ(opened.content.effects, kNumbers[number]);
      EXPECT_EQ(opened.content.view.format, PixelFormat::gray4);
    } else {
      EXPECT_EQ(opened.status, (Status{.error = Error::blob_damaged, .needed = kFormatAt})) << number;
    }
    bytes[kFormatAt] = static_cast<std::uint8_t>(number << 4 | 7);
    mend(bytes);
    EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::blob_damaged, .needed = kFormatAt})) << number;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
