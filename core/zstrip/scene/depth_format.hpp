// The formats of depth in a z-buffer. In all of them greater codes are nearer, and 0 is a cleared cell.
#pragma once

#include <bit>
#include <cstdint>

namespace zstrip {

enum class DepthFormat : std::uint8_t {
  z16,      ///< 16 bits, linear in 1/w over the frame's range
  float16,  ///< 3.13: 3 bits of exponent, 13 of mantissa, of near / w; needs no far bound. Perspective only
  z24,      ///< as z16 with 24 bits in a cell of 32
};

/// Bytes of a cell of the z-buffer.
constexpr std::uint32_t depth_bytes(DepthFormat format) { return format == DepthFormat::z24 ? 4 : 2; }

/// Returns the largest code of a fragment; the least is 1. A bias cannot leave this range.
constexpr std::uint32_t largest_depth_code(DepthFormat format) {
  return format == DepthFormat::z24 ? (1U << 24) - 2 : 65534;
}

/// Returns the octave of near / w (0.32) in DepthFormat::float16: codes of an octave are 2^(12 + octave) apart. The two
/// lowest exponents share octave 0, like denormals.
constexpr std::uint32_t float16_octave(std::uint32_t near_over_w) {
  const auto zeros = static_cast<std::uint32_t>(std::countl_zero(near_over_w));
  return zeros < 6 ? 6 - zeros : 0;
}

/// Converts near / w (0.32) to a code, rounded down.
constexpr std::uint16_t float16_code(std::uint32_t near_over_w) {
  const std::uint32_t octave = float16_octave(near_over_w);
  return static_cast<std::uint16_t>((octave << 13) + (near_over_w >> (12 + octave)));
}

}  // namespace zstrip
