// Vectors that are linear over a triangle in space. Multiplied by 1/w they are linear on the screen, and their
// direction needs no division.
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/direction.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/triangle_planes.hpp"

namespace zstrip::detail {

/// A vector of any scale.
struct Vector3 {
  std::int32_t x, y, z;
};

/// 1/w of a triangle's corners in one scale, at most 29 bits; all equal for an orthographic camera.
template <bool orthographic>
struct CornerInverses {
  std::int64_t q[3];

  /// `depth_offset` is DepthFit::offset.
  CornerInverses(const RasterVertex* const (&v)[3], std::int64_t depth_offset) : q{1, 1, 1} {
    if constexpr (!orthographic) {
      std::int64_t bits = 0;
      for (int i = 0; i < 3; ++i) bits |= q[i] = std::int64_t{v[i]->depth} + depth_offset;
      const int surplus = 35 - std::countl_zero(static_cast<std::uint64_t>(bits));
      for (std::int64_t& value : q) value = surplus >= 0 ? value >> surplus : value << -surplus;
    }
  }
};

/// A vector times 1/w over a triangle, scaled to 30 bits. The steps are rounded, half a unit for each of 4096 columns
/// and rows, so that values stay below 2^30 + 2^12.
class SpacePlanes {
 public:
  SpacePlanes() = default;
  template <bool orthographic>
  SpacePlanes(const TrianglePlanes& setup, const Vector3 (&corner)[3], const CornerInverses<orthographic>& inverses) {
    std::int64_t x[3], y[3], z[3];  // below 2^60: 31 bits times 29
    std::uint64_t bits = 1;
    for (int i = 0; i < 3; ++i) {
      x[i] = corner[i].x * inverses.q[i];
      y[i] = corner[i].y * inverses.q[i];
      z[i] = corner[i].z * inverses.q[i];
      bits |= static_cast<std::uint64_t>(magnitude(x[i]) | magnitude(y[i]) | magnitude(z[i]));
    }
    shift_ = 34 - std::countl_zero(bits);
    const auto plane = [&](std::int64_t(&value)[3]) {
      for (std::int64_t& each : value) each = shift_ >= 0 ? each >> shift_ : each * (std::int64_t{1} << -shift_);
      return setup.plane(value[0], value[1] - value[0], value[2] - value[0]);
    };
    x_ = plane(x), y_ = plane(y), z_ = plane(z);
  }

  /// Returns the vector's direction at a covered pixel. Columns and rows are relative to the anchor.
  Vector3 at(std::int32_t columns, std::int32_t rows) const {
    return {static_cast<std::int32_t>(x_.at(columns, rows)), static_cast<std::int32_t>(y_.at(columns, rows)),
            static_cast<std::int32_t>(z_.at(columns, rows))};
  }
  /// Returns the vector in the units of its corners. `one_over_w` is the value of the inverses at the pixel.
  Vector3 divided_at(std::int32_t columns, std::int32_t rows, std::uint32_t one_over_w) const {
    const Vector3 v = at(columns, rows);
    const Reciprocal r = reciprocal_of(one_over_w == 0 ? 1 : one_over_w);
    const int right = 30 - r.normalisation - shift_;  // 1/q = r 2^(normalisation - 62)
    const auto divided = [&](std::int32_t value) { return shifted(multiply_high(value, r.value), right); };
    return {divided(v.x), divided(v.y), divided(v.z)};
  }
  /// Returns the vector for orthographic corners.
  Vector3 undivided_at(std::int32_t columns, std::int32_t rows) const {
    const Vector3 v = at(columns, rows);
    return {shifted(v.x, -shift_), shifted(v.y, -shift_), shifted(v.z, -shift_)};
  }

 private:
  static std::int32_t shifted(std::int32_t value, int right) {
    if (right >= 0) return value >> (right < 31 ? right : 31);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(value) << (right > -31 ? -right : 31));
  }

  Plane x_{}, y_{}, z_{};
  int shift_ = 0;
};

}  // namespace zstrip::detail
