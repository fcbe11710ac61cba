// The depth range of a frame: the distances that the scene really has between near and far, and the constants that
// convert a distance to a 16-bit code. Greater codes are nearer.
#pragma once

#include <cstdint>

#include "zstrip/base/division.hpp"
#include "zstrip/camera.hpp"

namespace zstrip {

/// A distance along the viewing direction in 26.38, the format in which transforms are composed.
using Distance = std::int64_t;
inline constexpr int kDistanceBits = 38;

constexpr Distance distance_of(Fixed length) { return Distance{length} << (kDistanceBits - kFixedBits); }

/// Rounds down; returns the largest length if the distance does not fit.
constexpr Fixed length_of(Distance distance) {
  const Distance length = distance >> (kDistanceBits - kFixedBits);
  return length > INT32_MAX ? INT32_MAX : static_cast<Fixed>(length);
}

/// Codes run from 1 (at `far`) to 65534 (at `near`); 0 is a cleared cell. A half code is added once, at the vertex,
/// so that dropping the fraction rounds to nearest.
inline constexpr std::int64_t kDepthSpan = std::int64_t{65533} << 16;                           // 16.16 codes
inline constexpr std::int64_t kDepthOfFar = (std::int64_t{1} << 16) + (std::int64_t{1} << 15);  // 16.16 codes: 1.5

struct DepthFit {
  Distance near;
  Distance far;
  std::int64_t quotient_at_near;  ///< 16.16 codes: k / near, of the code's affine form k / w - offset (perspective)
  std::int64_t offset;            ///< 16.16 codes
};

/// Returns a fit to the distances near..far (0 < near <= far). A range that is too thin for 65533 codes is widened.
constexpr DepthFit fit_depth(Distance near, Distance far) {
  // Slightly wider than the bounds: transforms round, and a vertex outside the range would be clipped.
  near -= near >> 20;
  far += far >> 20;
  if (far - near < (near >> 8) + 1) far = near + (near >> 8) + 1;
  // offset = span * near / (far - near) + far's code. Both operands are shifted to 40 bits, so that the quotient keeps
  // 23 fraction bits.
  std::int64_t numerator = near;
  std::int64_t denominator = far - near;
  while (numerator >= std::int64_t{1} << 40) numerator >>= 1, denominator >>= 1;
  if (denominator == 0) denominator = 1;
  const auto ratio = static_cast<std::int64_t>(  // 9.23, at most 257
      seldom_quotient(static_cast<std::uint64_t>(numerator) << 23, static_cast<std::uint64_t>(denominator)));
  const std::int64_t quotient_at_far = (ratio * 65533) >> 7;  // 16.16 codes
  return {near, far, quotient_at_far + kDepthSpan, quotient_at_far - kDepthOfFar};
}

/// Snaps a depth to 1/8, 3/8, 5/8 or 7/8 of a code. The error of interpolation is below 1/8 code, so that the codes of
/// pixels never leave the range of the triangle's vertices.
constexpr std::uint32_t snap_depth(std::uint32_t depth) { return (depth & ~0x3FFFU) | 0x2000U; }

}  // namespace zstrip
