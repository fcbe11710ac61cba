// Perspective-correct texture coordinates: u/w, v/w and 1/w are linear on the screen, so 16 pixels need one division.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/texel_position.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/pixels/textured_run_state.hpp"
#include "zstrip/pixels/textured_scan.hpp"

namespace zstrip::detail {

struct TexelPosition {
  std::int32_t u, v;  ///< texels, 16.16, modulo 2^16 texels
};

/// A position, and the distance in the texture from this pixel to the next.
struct TexelFootprint {
  TexelPosition position;
  std::uint32_t texels;  ///< 24.8, a step to the right or downwards, whichever is longer; docs/conventions.md
};
/// The largest footprint: twice the largest texture.
inline constexpr std::uint32_t kMaxFootprint = 4096U << 8;

/// 1/w needs no interpolant of its own: with perspective, depth code = k / w - offset.
template <bool orthographic>
class TextureCoordinates {
 public:
  TextureCoordinates() = default;
  /// `depth_offset` is DepthFit::offset. `planes`: a PlaneSetup, or 32-bit MediumPlanes if fits_words().
  template <class Planes, class Vertex>
  TextureCoordinates(const Planes& planes, const Vertex* const (&v)[3], std::int64_t depth_offset) {
    using Value = typename Planes::Value;
    // Coordinates are relative to whole texels near vertex 0: small numbers keep their precision.
    base_u_ = v[0]->u & ~0xFFFF;
    base_v_ = v[0]->v & ~0xFFFF;
    const Value u0 = Value{v[0]->u} - base_u_, u1 = Value{v[1]->u} - base_u_, u2 = Value{v[2]->u} - base_u_;  // 17.16
    const Value v0 = Value{v[0]->v} - base_v_, v1 = Value{v[1]->v} - base_v_, v2 = Value{v[2]->v} - base_v_;
    if constexpr (orthographic) {
      u_over_w_ = planes.plane(u0, u1 - u0, u2 - u0);
      v_over_w_ = planes.plane(v0, v1 - v0, v2 - v0);
      return;
    }
    // Scales 1/w to at most 29 bits.
    const std::int64_t inverse0 = std::int64_t{v[0]->depth} + depth_offset;
    const std::int64_t inverse1 = std::int64_t{v[1]->depth} + depth_offset;
    const std::int64_t inverse2 = std::int64_t{v[2]->depth} + depth_offset;
    const int surplus = 35 - std::countl_zero(static_cast<std::uint64_t>(inverse0 | inverse1 | inverse2));
    const auto scaled = [surplus](std::int64_t inverse) {
      return surplus >= 0 ? shifted<Value>(inverse, surplus) : static_cast<Value>(inverse) << -surplus;
    };
    const Value q0 = scaled(inverse0), q1 = scaled(inverse1), q2 = scaled(inverse2);
    one_over_w_ = planes.plane(q0, q1 - q0, q2 - q0);
    // u/w has 29 bits and a sign; the product is below 2^33 * 2^29.
    const std::int64_t u0_by_w = long_product(u0, q0), v0_by_w = long_product(v0, q0);
    const std::int64_t u1_by_w = long_product(u1, q1), v1_by_w = long_product(v1, q1);
    const std::int64_t u2_by_w = long_product(u2, q2), v2_by_w = long_product(v2, q2);
    shift_ = std::max(0, 35 - std::countl_zero(magnitude(u0_by_w) | magnitude(v0_by_w) | magnitude(u1_by_w) |
                                               magnitude(v1_by_w) | magnitude(u2_by_w) | magnitude(v2_by_w)));
    const auto plane = [&planes, this](std::int64_t at0, std::int64_t at1, std::int64_t at2) {
      const Value first = shifted<Value>(at0, shift_);
      return planes.plane(first, shifted<Value>(at1, shift_) - first, shifted<Value>(at2, shift_) - first);
    };
    u_over_w_ = plane(u0_by_w, u1_by_w, u2_by_w);
    v_over_w_ = plane(v0_by_w, v1_by_w, v2_by_w);
  }
  /// True if the vertices' texture coordinates are close enough to each other for words of 32 bits, and their 1/w has
  /// less than 60 bits, so that no shift reaches 32. The coordinates are read only if they `may_be_far`.
  template <class Vertex>
  static bool fits_words(const Vertex* const (&v)[3], std::int64_t depth_offset, bool may_be_far) {
    if (static_cast<std::uint32_t>(depth_offset >> 32) >> 27 != 0) return false;
    if (!may_be_far) return true;
    // Compares halves, because differences of whole values need 33 bits.
    const auto near = [](std::int32_t a, std::int32_t b) {
      return (static_cast<std::uint32_t>((a >> 1) - (b >> 1)) + (std::uint32_t{1} << 29)) >> 30 == 0;
    };
    return near(v[1]->u, v[0]->u) && near(v[2]->u, v[0]->u) && near(v[1]->v, v[0]->v) && near(v[2]->v, v[0]->v);
  }

  /// u/w, v/w and 1/w at a pixel of a row.
  struct Place {
    std::uint32_t u_over_w, v_over_w, one_over_w;
  };
  /// Returns the place of a pixel relative to the anchor.
  Place place(std::int32_t columns, std::int32_t rows) const {
    Place place{u_over_w_.at(columns, rows), v_over_w_.at(columns, rows), 0};
    if constexpr (!orthographic) place.one_over_w = one_over_w_.at(columns, rows);
    return place;
  }
  /// Returns place() of the pixel `columns` further to the right, exactly: sums are modulo 2^32.
  Place right_of(Place place, std::int32_t columns) const {
    const auto count = static_cast<std::uint32_t>(columns);
    place.u_over_w += u_over_w_.step_x * count;
    place.v_over_w += v_over_w_.step_x * count;
    if constexpr (!orthographic) place.one_over_w += one_over_w_.step_x * count;
    return place;
  }

  /// Starts whole runs: stores the place of their first pixel, and the other values that the assembly needs.
  void start_runs(TexturedRunsState& state, const Place& place, TexelPosition from, std::uint32_t columns) const {
    state.u_over_w = place.u_over_w, state.v_over_w = place.v_over_w, state.one_over_w = place.one_over_w;
    state.u_over_w_step = u_over_w_.step_x * columns, state.v_over_w_step = v_over_w_.step_x * columns;
    state.one_over_w_step = one_over_w_.step_x * columns;
    state.base_u = base_u_, state.base_v = base_v_;
    state.from_u = from.u, state.from_v = from.v;
    state.right_shift = 30 - shift_;
  }

  /// Sets the planes for a triangle's rows.
  void start_rows(TexturedScan& scan) const {
    scan.set(TexturedScan::u_over_w, u_over_w_);
    scan.set(TexturedScan::v_over_w, v_over_w_);
    if constexpr (!orthographic) scan.set(TexturedScan::one_over_w, one_over_w_);
    scan.base_u = base_u_, scan.base_v = base_v_;
    scan.right_shift = 30 - shift_;
  }

  /// Returns the exact position at a covered pixel.
  // GCC does not inline it in a file with many pipelines, which costs 2 % of CT on the host.
  [[gnu::always_inline]] TexelPosition at(const Place& place) const {
    return position(place, base_u_, base_v_, 30 - shift_);
  }
  /// Returns the position from the values of a TexturedScan.
  [[gnu::always_inline]] static TexelPosition position(const Place& place, std::int32_t base_u, std::int32_t base_v,
                                                       std::int32_t right_shift) {
    const auto u = static_cast<std::int32_t>(place.u_over_w);
    const auto v = static_cast<std::int32_t>(place.v_over_w);
    if constexpr (orthographic) {
      return {wrapping_sum(u, base_u), wrapping_sum(v, base_v)};
    } else if constexpr (kDividesTexelsInAssembly) {
      const std::uint64_t divided = divide_texels_thumb1(place.one_over_w, place.u_over_w, place.v_over_w, right_shift);
      return {wrapping_sum(static_cast<std::int32_t>(divided), base_u),
              wrapping_sum(static_cast<std::int32_t>(divided >> 32), base_v)};
    } else {
      const Reciprocal r = inverse(place);
      const std::int32_t right = right_shift - r.normalisation;  // 1/q = r * 2^(normalisation - 62)
      return {wrapping_sum(divided(u, r, right), base_u), wrapping_sum(divided(v, r, right), base_v)};
    }
  }
  [[gnu::always_inline]] TexelPosition at(std::int32_t columns, std::int32_t rows) const {
    return at(place(columns, rows));
  }

  /// Returns the position and its footprint: the derivatives of u and v, from the same division.
  TexelFootprint footprint_at(std::int32_t columns, std::int32_t rows) const {
    const Place there = place(columns, rows);
    const auto step = [&](std::uint32_t Plane::*direction) {
      if constexpr (orthographic) {
        return length(static_cast<std::int32_t>(u_over_w_.*direction), static_cast<std::int32_t>(v_over_w_.*direction));
      } else {
        // d(u) = d(u/w / 1/w), times (1/w)^2. Below 2^61.
        const std::int64_t w = static_cast<std::int32_t>(there.one_over_w);
        const std::int64_t w_step = static_cast<std::int32_t>(one_over_w_.*direction);
        const auto derivative = [&](std::uint32_t value, std::uint32_t value_step) {
          return static_cast<std::int32_t>(value_step) * w - static_cast<std::int32_t>(value) * w_step;
        };
        return length(derivative(there.u_over_w, u_over_w_.*direction),
                      derivative(there.v_over_w, v_over_w_.*direction));
      }
    };
    const std::uint64_t longer = std::max(step(&Plane::step_x), step(&Plane::step_y));
    const auto limited = [](std::uint64_t texels) {
      return static_cast<std::uint32_t>(std::min(texels, std::uint64_t{kMaxFootprint}));
    };
    if constexpr (orthographic) {
      return {at(there), limited(longer >> 8)};
    } else {
      const Reciprocal r = inverse(there);
      const int zeros = std::countl_zero(longer | 1);
      const std::uint32_t squared = multiply_high(static_cast<std::uint32_t>(r.value),
                                                  static_cast<std::uint32_t>(r.value));  // 28..30 bits
      const std::uint32_t product = multiply_high(static_cast<std::uint32_t>((longer << zeros) >> 32), squared);
      // longer * 2^zeros / 2^32, (1/q)^2 = squared * 2^(2 * normalisation - 92), 16.16 to 24.8.
      const int right = 36 + zeros - 2 * r.normalisation - shift_;
      return {at(there), right <= 0 ? kMaxFootprint : limited(product >> (right < 31 ? right : 31))};
    }
  }

 private:
  template <class Value>
  static Value shifted(std::int64_t value, int shift) {
    if constexpr (sizeof(Value) == sizeof(std::int32_t)) return shifted_to_word(value, shift);
    return static_cast<Value>(value >> shift);
  }
  static std::uint64_t magnitude(std::int64_t value) { return static_cast<std::uint64_t>(value < 0 ? -value : value); }
  /// Returns an estimate of the hypotenuse, up to an eighth too long: the longer leg plus half of the shorter one.
  static std::uint64_t length(std::int64_t a, std::int64_t b) {
    const std::uint64_t x = magnitude(a), y = magnitude(b);
    return std::max(x, y) + std::min(x, y) / 2;
  }
  static Reciprocal inverse(const Place& place) {
    return reciprocal_of(place.one_over_w == 0 ? 1 : place.one_over_w, 32 - 29);  // the largest vertex has 29 bits
  }
  static std::int32_t divided(std::int32_t value, const Reciprocal& r, std::int32_t right) {
    const std::int32_t high = multiply_high(value, r.value);
    if (right >= 0) return high >> (right < 31 ? right : 31);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(high) << (right > -31 ? -right : 31));
  }
  static std::int32_t wrapping_sum(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
  }

  Plane u_over_w_, v_over_w_, one_over_w_;  // not zero-initialised: that would cost three calls for each triangle on a
                                            // Cortex-M0
  std::int32_t base_u_ = 0, base_v_ = 0;
  int shift_ = 0;
};

}  // namespace zstrip::detail
