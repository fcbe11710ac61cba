// Places between keyframes, for instances and for joints.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"

namespace zstrip::detail {

/// The two keyframes around a time, and how far it is from the first to the second (0.16).
struct Interval {
  const Keyframe* from;
  const Keyframe* to;
  std::uint32_t share;
};

/// Of a track, any time.
Interval interval_at(const Animation& animation, const Track& track, std::uint32_t time);

constexpr Fixed between(Fixed a, Fixed b, std::uint32_t share) {
  return static_cast<Fixed>(a + (((std::int64_t{b} - a) * share) >> 16));
}
constexpr Vec3 between(const Vec3& a, const Vec3& b, std::uint32_t share) {
  return {between(a.x, b.x, share), between(a.y, b.y, share), between(a.z, b.z, share)};
}

/// 2.30; between two unit quaternions it is shorter than they are.
struct Quaternion {
  std::int32_t x, y, z, w;
};

/// From 1.15, linearly.
Quaternion between(const std::int16_t (&a)[4], const std::int16_t (&b)[4], std::uint32_t share);

/// Scaled, then rotated, then moved. The quaternion's length means nothing; it is at least a half.
Transform placed(const Quaternion& rotation, const Vec3& translation, const Vec3& scale);

}  // namespace zstrip::detail
