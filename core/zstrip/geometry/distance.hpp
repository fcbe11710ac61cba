// Converts a depth back to the distance along the viewing direction, on which fog depends.
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/geometry/depth_fit.hpp"

namespace zstrip::detail {

/// The frame's constants. Perspective: distance = scale 2^exponent / q, where q = k / w is a depth plus
/// DepthFit::offset. Orthographic: distance = far - ((depth - far's depth) scale >> 32).
struct DistanceScale {
  std::uint64_t scale;
  std::int32_t exponent;
  Fixed far;  ///< 16.16
};

/// Returns the depth between near and far in 1/2^32 of all codes, for orthographic cameras; see depth_mapping.
constexpr std::int64_t depth_span(Effects effects) {
  if (effects.has(effect::depth_ranges)) return std::int64_t{(1 << 14) - 3} << 16;
  return effects.has(effect::depth_24) ? (std::int64_t{1} << 32) - (3 << 8) : kDepthSpan;
}

/// `fit` is the frame's fit while triangles are drawn.
constexpr DistanceScale distance_scale(const DepthFit& fit, bool orthographic, std::int64_t span) {
  if (orthographic) {
    const auto range = static_cast<std::uint64_t>(length_of(fit.far)) - static_cast<std::uint64_t>(length_of(fit.near));
    return {(range << 32) / static_cast<std::uint64_t>(span), 0, length_of(fit.far)};
  }
  // The product of near (26.38) and quotient_at_near (1/2^32 codes), with 32 bits.
  const auto near = static_cast<std::uint64_t>(fit.near), quotient = static_cast<std::uint64_t>(fit.quotient_at_near);
  const int near_zeros = std::countl_zero(near), quotient_zeros = std::countl_zero(quotient);
  const auto mantissa = multiply_high(static_cast<std::uint32_t>((near << near_zeros) >> 32),
                                      static_cast<std::uint32_t>((quotient << quotient_zeros) >> 32));
  // Each factor was shifted by 32 and their product by 32; the product with the reciprocal (2^-62) will be shifted by
  // 32; 38 fraction bits become 16.
  return {mantissa, 44 - near_zeros - quotient_zeros, 0};
}

/// Returns the distance of a depth, 16.16. `depth_offset` comes from the frame's mapping: DepthFit::offset with
/// perspective, else the depth of `far`.
template <bool orthographic>
constexpr Fixed distance_at(const DistanceScale& scale, std::uint32_t depth, std::int64_t depth_offset) {
  if constexpr (orthographic) {
    const std::uint32_t nearer = depth - static_cast<std::uint32_t>(depth_offset);
    const Fixed distance = scale.far - static_cast<Fixed>((nearer * scale.scale) >> 32);
    return distance < 0 ? 0 : distance;
  } else {
    const std::int64_t q = std::int64_t{depth} + depth_offset;
    if (q <= 0) return INT32_MAX;
    const int zeros = std::countl_zero(static_cast<std::uint64_t>(q));
    const auto inverse = static_cast<std::uint32_t>(
        reciprocal(static_cast<std::uint32_t>((static_cast<std::uint64_t>(q) << zeros) >> 32)));
    const std::uint32_t high = multiply_high(static_cast<std::uint32_t>(scale.scale), inverse);
    const int left = scale.exponent + zeros - 32;
    if (left <= 0) return static_cast<Fixed>(left > -32 ? high >> -left : 0);
    return left < 31 && high >> (31 - left) == 0 ? static_cast<Fixed>(high << left) : INT32_MAX;
  }
}

}  // namespace zstrip::detail
