// The character's walk, computed at compile time: two steps a second, on the spot. Angles are sines of the phase,
// chosen by eye; at phase 0 the left heel touches the ground.
#pragma once

#include <array>

#include "shape.hpp"

namespace zstrip::scenes::character_shape {

struct Quaternion {
  double x, y, z, w;
};
consteval Quaternion about_x(double angle) {
  return {compile_time::sine(angle / 2), 0, 0, compile_time::cosine(angle / 2)};
}
consteval Quaternion about_y(double angle) {
  return {0, compile_time::sine(angle / 2), 0, compile_time::cosine(angle / 2)};
}
/// Rotates by b, then by a.
consteval Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

/// Leg and arm of one side. A positive rotation about x swings a hanging limb to the back.
struct Side {
  double thigh, shin, foot, toes, arm, forearm;
};
consteval Side side_at(double phase) {
  const double forward = compile_time::cosine(phase), lifted = -compile_time::sine(phase + 0.3);
  Side side{};
  side.thigh = -0.44 * forward - 0.06;
  side.shin = 0.08 + 0.95 * (lifted > 0 ? lifted * lifted : 0);
  side.toes = forward < 0 ? -0.5 * forward * forward : 0;
  side.foot = -0.75 * (side.thigh + side.shin) - 0.3 * side.toes;
  side.arm = 0.50 * forward;
  side.forearm = -0.42 + 0.28 * forward;
  return side;
}

/// Returns the rotation of each joint relative to its parent.
consteval std::array<Quaternion, kCharacterJoints> rotations_at(double phase) {
  const double forward = compile_time::cosine(phase);
  std::array<Quaternion, kCharacterJoints> joints{};
  joints[kPelvis] = about_y(-0.12 * forward);
  joints[kSpine] = about_x(0.04) * about_y(0.10 * forward);
  joints[kChest] = about_y(0.14 * forward);
  joints[kNeck] = about_y(-0.06 * forward);
  joints[kHead] = about_x(-0.03) * about_y(-0.06 * forward);
  const auto set = [&](const Side& side, JointName arm, JointName thigh) consteval {
    joints[arm] = about_x(side.arm);
    joints[arm + 1U] = about_x(side.forearm);
    joints[arm + 2U] = about_x(-0.1);
    joints[thigh] = about_x(side.thigh);
    joints[thigh + 1U] = about_x(side.shin);
    joints[thigh + 2U] = about_x(side.foot);
    joints[thigh + 3U] = about_x(side.toes);
  };
  set(side_at(phase), kLeftArm, kLeftThigh);
  set(side_at(phase + compile_time::kPi), kRightArm, kRightThigh);
  return joints;
}

consteval Vec3 offset_of(std::size_t joint, double height) {
  const JointPlace& own = kJointPlaces[joint];
  const Vector origin = own.parent == kNoJoint ? Vector{0, kMiddle, 0} : kJointPlaces[own.parent].place;
  const Vector offset = own.place - origin;
  return {fixed(offset.x), fixed(offset.y + height), fixed(offset.z)};
}

consteval std::array<Keyframe, kCharacterJoints * kCharacterKeys> keyframes() {
  std::array<Keyframe, kCharacterJoints * kCharacterKeys> result{};
  for (std::size_t key = 0; key < kCharacterKeys; ++key) {
    const double share = static_cast<double>(key) / (kCharacterKeys - 1), phase = 2 * compile_time::kPi * share;
    const auto rotations = rotations_at(phase);
    for (std::size_t joint = 0; joint < kCharacterJoints; ++joint) {
      // The figure is lowest when both feet touch the ground.
      const double height = joint == kPelvis ? -0.028 - 0.02 * compile_time::cosine(2 * phase) : 0;
      const Quaternion& q = rotations[joint];
      const auto rounded = [](double c) consteval {
        return static_cast<std::int16_t>(compile_time::nearest(32767 * c));
      };
      result[joint * kCharacterKeys + key] = {
          .time = static_cast<std::uint32_t>(compile_time::nearest(kCharacterStride * share)),
          .rotation = {rounded(q.x), rounded(q.y), rounded(q.z), rounded(q.w)},
          .translation = offset_of(joint, height),
          .scale = {kFixedOne, kFixedOne, kFixedOne}};
    }
  }
  return result;
}

consteval std::array<Track, kCharacterJoints> tracks() {
  std::array<Track, kCharacterJoints> result{};
  for (std::size_t joint = 0; joint < kCharacterJoints; ++joint) {
    result[joint] = {static_cast<std::uint16_t>(joint), static_cast<std::uint16_t>(kCharacterKeys),
                     static_cast<std::uint32_t>(joint * kCharacterKeys)};
  }
  return result;
}

}  // namespace zstrip::scenes::character_shape
