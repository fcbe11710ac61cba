// Fog: computes how visible a fragment is at its distance, with a power of two from a table of 17 numbers. It is
// computed for every 16th pixel and interpolated linearly between.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/geometry/distance.hpp"
#include "zstrip/kernels/triangle_planes.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// The frame's fog.
struct FogCurve {
  DistanceScale distance;
  Fixed end, range;            ///< 16.16, linear; range > 0
  std::int32_t inverse_range;  ///< reciprocal() of range << normalisation
  std::uint32_t density;       ///< 16.16; FogMode::exponential: times log2 e, with `normalisation` more fraction bits
  std::uint8_t normalisation;
  FogMode mode;
  Colour colour;
};
static_assert(sizeof(FogCurve) == 40);

inline constexpr std::uint32_t kLog2E = 94548;  // 16.16

constexpr FogCurve fog_curve(const Fog& fog, const DistanceScale& distance) {
  const Fixed range = fog.end > fog.start ? fog.end - fog.start : 1;
  const std::uint64_t density = fog.density > 0 ? static_cast<std::uint64_t>(fog.density) : 0;
  FogCurve curve{distance, fog.end, range, 0, static_cast<std::uint32_t>(density), 0, fog.mode, fog.colour};
  if (fog.mode == FogMode::exponential) {
    // All bits of a small density: below 2^48, so that at most 16 of 32 fraction bits are dropped.
    const std::uint64_t scaled = density * kLog2E;
    const int zeros = std::countl_zero(scaled | 1);
    curve.density = static_cast<std::uint32_t>((scaled << zeros) >> 32);
    curve.normalisation = static_cast<std::uint8_t>(zeros - 16);
  } else {
    curve.normalisation = static_cast<std::uint8_t>(std::countl_zero(static_cast<std::uint32_t>(range)));
    curve.inverse_range = reciprocal(static_cast<std::uint32_t>(range) << curve.normalisation);
  }
  return curve;
}

/// 2^(-i / 16), 0.16.
inline constexpr std::uint32_t kPowersOfTwo[17] = {65536, 62757, 60097, 57549, 55109, 52773, 50535, 48393, 46341,
                                                   44376, 42495, 40693, 38968, 37316, 35734, 34219, 32768};

/// Returns 2^-exponent in 0.16 (1.0 is 65536) for an exponent in 16.16; the error is below 1/2000.
constexpr std::uint32_t power_of_half(std::uint64_t exponent) {
  const std::uint64_t whole = exponent >> 16;
  if (whole > 16) return 0;
  const auto fraction = static_cast<std::uint32_t>(exponent & 0xFFFF);
  const std::uint32_t at = fraction >> 12, between = fraction & 0xFFF;
  const std::uint32_t drop = ((kPowersOfTwo[at] - kPowersOfTwo[at + 1]) * between) >> 12;
  return (kPowersOfTwo[at] - drop) >> whole;
}

/// Returns how visible a surface at `distance` (16.16, >= 0) is: 0..65536.
constexpr std::int32_t visibility(const FogCurve& fog, Fixed distance) {
  const auto w = static_cast<std::uint64_t>(distance);  // times the density below 2^63: 2^31 * 2^32
  switch (fog.mode) {
    case FogMode::linear: {
      const std::int64_t left = std::clamp<std::int64_t>(std::int64_t{fog.end} - distance, 0, fog.range);
      const auto normalised = static_cast<std::uint32_t>(left) << fog.normalisation;
      return static_cast<std::int32_t>(multiply_high(normalised, static_cast<std::uint32_t>(fog.inverse_range)) +
                                       8192) >>
             14;
    }
    case FogMode::exponential:
      return static_cast<std::int32_t>(power_of_half((w * fog.density) >> (16 + fog.normalisation)));
    case FogMode::exponential_squared: break;
  }
  const std::uint64_t product = std::min<std::uint64_t>((w * fog.density) >> 16, 8 << 16);  // 4.16
  return static_cast<std::int32_t>(power_of_half(((product * product) >> 16) * kLog2E >> 16));
}

/// The distance of a triangle over the picture.
template <bool orthographic>
class FogPlane {
 public:
  FogPlane() = default;
  /// `depth_offset`: DepthFit::offset with perspective, else the depth of `far`.
  FogPlane(const FogCurve& fog, const TrianglePlanes& setup, const RasterVertex* const (&v)[3],
           std::int64_t depth_offset)
      : fog_(&fog) {
    std::int64_t value[3];
    if constexpr (orthographic) {
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t nearer = v[i]->depth - static_cast<std::uint32_t>(depth_offset);
        value[i] = fog.distance.far - static_cast<std::int64_t>((nearer * fog.distance.scale) >> 32);
      }
    } else {
      std::int64_t bits = 0;
      for (int i = 0; i < 3; ++i) bits |= value[i] = std::int64_t{v[i]->depth} + depth_offset;
      surplus_ = 35 - std::countl_zero(static_cast<std::uint64_t>(bits));  // to 29 bits
      for (std::int64_t& q : value) q = surplus_ >= 0 ? q >> surplus_ : q << -surplus_;
    }
    plane_ = setup.plane(value[0], value[1] - value[0], value[2] - value[0]);
  }

  /// Returns the visibility, 0..65536, at a covered pixel relative to the anchor.
  std::int32_t at(std::int32_t columns, std::int32_t rows) const {
    return visibility(*fog_, distance(plane_.at(columns, rows)));
  }

 private:
  Fixed distance(std::uint32_t value) const {
    if constexpr (orthographic) {
      return std::max<Fixed>(static_cast<Fixed>(value), 0);  // rounding may leave the range
    } else {
      const Reciprocal r = reciprocal_of(value == 0 ? 1 : value);
      const std::uint32_t high =
          multiply_high(static_cast<std::uint32_t>(fog_->distance.scale), static_cast<std::uint32_t>(r.value));
      const int left = fog_->distance.exponent + r.normalisation - surplus_;
      if (left <= 0) return static_cast<Fixed>(left > -32 ? high >> -left : 0);
      return left < 31 && high >> (31 - left) == 0 ? static_cast<Fixed>(high << left) : INT32_MAX;
    }
  }

  const FogCurve* fog_ = nullptr;
  Plane plane_{};
  int surplus_ = 0;
};

}  // namespace zstrip::detail
