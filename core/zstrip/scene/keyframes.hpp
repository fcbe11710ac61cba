// Interpolation between keyframes, for instances and for joints.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"

namespace zstrip::detail {

/// The two keyframes around a time, and the position of the time between them (0.16).
struct Interval {
  const Keyframe* from;
  const Keyframe* to;
  std::uint32_t share;
};

/// Returns the interval of a track at any time.
Interval interval_at(const Animation& animation, const Track& track, std::uint32_t time);

constexpr Fixed between(Fixed a, Fixed b, std::uint32_t share) {
  return static_cast<Fixed>(a + (((std::int64_t{b} - a) * share) >> 16));
}
constexpr Vec3 between(const Vec3& a, const Vec3& b, std::uint32_t share) {
  return {between(a.x, b.x, share), between(a.y, b.y, share), between(a.z, b.z, share)};
}

/// A quaternion in 2.30. Interpolation between two unit quaternions makes it shorter than one.
struct Quaternion {
  std::int32_t x, y, z, w;
};

/// Interpolates two quaternions in 1.15 linearly.
Quaternion between(const std::int16_t (&a)[4], const std::int16_t (&b)[4], std::uint32_t share);

/// Returns the transform that scales, then rotates, then moves. The quaternion may have any length of at least a half.
Transform placed(const Quaternion& rotation, const Vec3& translation, const Vec3& scale);

}  // namespace zstrip::detail
