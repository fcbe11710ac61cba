// Computes how far apart surfaces must be for each depth format to sort them, and the cheapest format that sorts the
// surfaces of a scene. constexpr, so that the choice can be a renderer's effect:
//     constexpr Effects kEffects = effects_of(scene, camera) | depth_effect(cheapest_depth_format(range, farthest,
//     separation));
#pragma once

#include <cstdint>
#include <initializer_list>

#include "zstrip/camera.hpp"
#include "zstrip/scene/depth_format.hpp"

namespace zstrip {

/// The distances between which depth is stored, in view units (16.16), 0 < near < far: those of the scene, to which a
/// frame fits its codes, or the camera's with Camera::fixed_depth_range.
struct DepthRange {
  Fixed near, far;
  Projection projection = Projection::perspective;
};

constexpr bool available(DepthFormat format, Projection projection) {
  return projection == Projection::perspective || format != DepthFormat::float16;
}

/// Returns the smallest distance between two surfaces, at `distance` (near..far), at which every pixel is sorted right,
/// also if both are tilted by up to 45 degrees: 2.5 codes; docs/numerics.md has measurements. In view units, 32.32,
/// rounded up. UINT64_MAX if the format has no codes, or does not support this projection.
constexpr std::uint64_t depth_separation(DepthFormat format, const DepthRange& range, Fixed distance) {
  constexpr std::uint64_t kNever = UINT64_MAX;
  const auto near = static_cast<std::uint64_t>(range.near), far = static_cast<std::uint64_t>(range.far);
  const auto w = static_cast<std::uint64_t>(distance);
  if (!available(format, range.projection)) return kNever;
  const auto for_codes = [](std::uint64_t code) { return code > kNever / 5 - 1 ? kNever : (code + 1) * 5 / 2; };
  if (range.projection == Projection::orthographic) return for_codes(((far - near) << 16) / largest_depth_code(format));
  if (format == DepthFormat::float16) {
    const auto near_over_w = static_cast<std::uint32_t>((near << 32) / w - 1);  // 0.32
    const std::uint32_t codes = near_over_w >> (12 + float16_octave(near_over_w));
    return codes == 0 ? kNever : for_codes((w << 16) / codes);
  }
  // One code's share of 1/near - 1/far, times w^2.
  std::uint64_t spread = (w << 16) / near - (w << 16) / far;  // 32.16: w / near - w / far
  int dropped = 0;
  for (; spread >> 32 != 0; spread >>= 1) ++dropped;
  const std::uint64_t code = spread * w / largest_depth_code(format);
  // 1/w itself has 28 bits, which limits z24 if near and far are close together.
  const std::uint64_t limit = w >> 12;
  if (code >> (63 - dropped) != 0) return kNever;
  return for_codes(code << dropped > limit ? code << dropped : limit);
}

/// Returns the cheapest format that sorts surfaces `separation` (32.32) apart, from range.near to `farthest` (at most
/// range.far): z16, the small float or z24. Returns z24 if none does.
constexpr DepthFormat cheapest_depth_format(const DepthRange& range, Fixed farthest, std::uint64_t separation) {
  for (const DepthFormat format : {DepthFormat::z16, DepthFormat::float16}) {
    // Every format gets coarser with the distance.
    if (depth_separation(format, range, farthest) <= separation) return format;
  }
  return DepthFormat::z24;
}

}  // namespace zstrip
