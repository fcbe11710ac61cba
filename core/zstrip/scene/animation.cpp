// Interpolates keyframes. Runs once an instance and frame: products of 64 bits, one reciprocal, one division.
#include "zstrip/animation.hpp"

#include <bit>

#include "zstrip/base/math.hpp"
#include "zstrip/scene/keyframes.hpp"

namespace zstrip {
namespace {

constexpr Fixed kMaxScale = 255 * kFixedOne;

constexpr std::int32_t dot(const Keyframe& a, const Keyframe& b) {
  std::int32_t sum = 0;  // 4.28: four products of 1.15 fit for any bits
  for (int i = 0; i < 4; ++i) sum += (std::int32_t{a.rotation[i]} * b.rotation[i]) >> 2;
  return sum;
}

constexpr bool in_range(const Vec3& scale) {
  for (const Fixed s : {scale.x, scale.y, scale.z}) {
    if (s < -kMaxScale || s > kMaxScale) return false;
  }
  return true;
}

/// Sets the rows of the rotation, 16.16, from a quaternion, which need not be of unit length.
void rotate(const detail::Quaternion& quaternion, Fixed (&m)[3][3]) {
  const std::int64_t q[4] = {quaternion.x, quaternion.y, quaternion.z, quaternion.w};
  std::uint32_t square = 0;  // 2.30, at least a quarter: adjacent keyframes are at most 90 degrees apart as vectors of
                             // four
  for (const std::int64_t c : q) square += static_cast<std::uint32_t>((c * c) >> 30);
  const int zeros = std::countl_zero(square);
  const std::int64_t inverse = zstrip::reciprocal(square << zeros);  // 2^62 / (square 2^zeros)
  // 2 q_i q_j / |q|^2 in 16.16, rounded to nearest.
  const auto twice = [&](int i, int j) {
    const int shift = 45 - zeros;
    const std::int64_t product = ((q[i] * q[j]) >> 30) * inverse;
    return static_cast<Fixed>((product + (std::int64_t{1} << (shift - 1))) >> shift);
  };
  const Fixed xx = twice(0, 0), yy = twice(1, 1), zz = twice(2, 2);
  const Fixed xy = twice(0, 1), xz = twice(0, 2), yz = twice(1, 2);
  const Fixed xw = twice(0, 3), yw = twice(1, 3), zw = twice(2, 3);
  m[0][0] = kFixedOne - yy - zz, m[0][1] = xy - zw, m[0][2] = xz + yw;
  m[1][0] = xy + zw, m[1][1] = kFixedOne - xx - zz, m[1][2] = yz - xw;
  m[2][0] = xz - yw, m[2][1] = yz + xw, m[2][2] = kFixedOne - xx - yy;
}

}  // namespace

namespace detail {

Interval interval_at(const Animation& animation, const Track& track, std::uint32_t time) {
  return interval_in(animation.keyframes.subspan(track.first, track.count), time % animation.duration);
}

Quaternion between(const std::int16_t (&a)[4], const std::int16_t (&b)[4], std::uint32_t share) {
  const auto component = [&](int i) {
    const std::int64_t way = (std::int64_t{b[i]} - a[i]) * share;  // 1.31
    return static_cast<std::int32_t>(a[i] * 32768 + (way >> 1));
  };
  return {component(0), component(1), component(2), component(3)};
}

Transform placed(const Quaternion& quaternion, const Vec3& translation, const Vec3& scale) {
  Fixed rotation[3][3];
  rotate(quaternion, rotation);
  Transform transform{};
  for (int row = 0; row < 3; ++row) {
    const auto scaled = [&](int column, Fixed by) {
      return static_cast<Fixed>((std::int64_t{rotation[row][column]} * by + kFixedOne / 2) >> kFixedBits);
    };
    transform.m[row][0] = scaled(0, scale.x);
    transform.m[row][1] = scaled(1, scale.y);
    transform.m[row][2] = scaled(2, scale.z);
  }
  transform.m[0][3] = translation.x;
  transform.m[1][3] = translation.y;
  transform.m[2][3] = translation.z;
  return transform;
}

}  // namespace detail

Status validate(const Animation& animation, std::uint32_t instances) {
  for (std::size_t i = 0; i < animation.tracks.size(); ++i) {
    const Status wrong{.error = Error::animation, .needed = static_cast<std::uint32_t>(i)};
    const Track& track = animation.tracks[i];
    const std::size_t all = animation.keyframes.size();
    if (animation.duration == 0 || track.instance >= instances || track.count == 0) return wrong;
    if (track.first > all || track.count > all - track.first) return wrong;
    const std::span keyframes = animation.keyframes.subspan(track.first, track.count);
    for (std::size_t k = 0; k < keyframes.size(); ++k) {
      constexpr std::int32_t kUnit = 1 << 28, kTolerance = kUnit / 100;
      const std::int32_t square = dot(keyframes[k], keyframes[k]);
      if (square < kUnit - kTolerance || square > kUnit + kTolerance || !in_range(keyframes[k].scale)) return wrong;
      if (k == 0) continue;
      if (keyframes[k].time <= keyframes[k - 1].time || dot(keyframes[k], keyframes[k - 1]) < 0) return wrong;
    }
  }
  return {};
}

void pose(const Animation& animation, std::uint32_t time, std::span<Instance> instances) {
  for (const Track& track : animation.tracks) {
    const auto [from, to, share] = detail::interval_at(animation, track, time);
    instances[track.instance].transform = detail::placed(detail::between(from->rotation, to->rotation, share),
                                                         detail::between(from->translation, to->translation, share),
                                                         detail::between(from->scale, to->scale, share));
  }
}

}  // namespace zstrip
