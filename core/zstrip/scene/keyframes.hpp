// Interpolation between keyframes, for instances, joints and weights of morph targets.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"

namespace zstrip::detail {

/// The two keyframes around a time, and the position of the time between them (0.16).
template <class Key>
struct IntervalOf {
  const Key* from;
  const Key* to;
  std::uint32_t share;
};
using Interval = IntervalOf<Keyframe>;

/// Returns the position of `time` between `from` and `to`, 0.16. from <= time < to.
inline std::uint32_t fraction(std::uint32_t from, std::uint32_t time, std::uint32_t to) {
  std::uint32_t length = to - from, passed = time - from;
  const int shift = 16 - std::countl_zero(length);
  if (shift > 0) length >>= shift, passed >>= shift;
  return (passed << 16) / length;
}

/// Returns the interval around `time` in keyframes of ascending times, at least one.
template <class Key>
IntervalOf<Key> interval_in(std::span<const Key> keyframes, std::uint32_t time) {
  // Keyframes below `low` are not later than `time`; keyframes from `high` on are later.
  std::size_t low = 0, high = keyframes.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (keyframes[middle].time <= time) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const Key& from = keyframes[low == 0 ? 0 : low - 1];
  if (low == 0 || low == keyframes.size()) return {&from, &from, 0};
  return {&from, &keyframes[low], fraction(from.time, time, keyframes[low].time)};
}

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
