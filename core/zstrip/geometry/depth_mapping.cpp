// The constants of the depth mappings; see depth_mapping.hpp.
#include "zstrip/geometry/depth_mapping.hpp"

#include <bit>

#include "zstrip/base/math.hpp"

namespace zstrip::detail {
namespace {

constexpr std::int64_t kAllCodes = std::int64_t{1} << 32;

/// Returns near / (far - near) with 39 fraction bits, at most 257: a range is never thinner than near / 256.
std::int64_t near_over_range(const DepthFit& fit) {
  std::int64_t near = fit.near;
  std::int64_t range = fit.far - fit.near;
  while (range > std::int64_t{1} << 54) near >>= 1, range >>= 1;
  return long_quotient(near, range, 39);
}

/// Returns the mapping in which depth runs from `far` to `far` + all codes - `unused`.
DepthMapping linear_in_1_over_w(const DepthFit& fit, std::int64_t far, std::int64_t unused) {
  const std::int64_t ratio = near_over_range(fit);
  const std::int64_t span = kAllCodes - unused;
  const std::int64_t quotient_at_far = (ratio >> 7) - ((ratio * unused) >> 39);  // ratio * span / 2^39
  return {quotient_at_far + span, quotient_at_far - far, span, far};
}

/// Sets depth_scale * 2^depth_shift to its product with numerator / divisor.
void scale_depth(CompiledInstance& instance, std::int64_t numerator, std::int64_t divisor) {
  const auto factor = static_cast<std::uint64_t>(long_quotient(numerator, divisor, 31));  // 1.31
  const std::uint64_t product = instance.depth_scale * factor;
  if (product == 0) {
    instance.depth_scale = 0;
    return;
  }
  const int zeros = std::countl_zero(product);
  auto scale = static_cast<std::uint32_t>((product << zeros) >> 32);
  int shift = instance.depth_shift + 1 - zeros;
  if (shift < 0) {
    scale = shift > -32 ? scale >> -shift : 0;
    shift = 0;
  }
  instance.depth_scale = scale;
  instance.depth_shift = static_cast<std::uint8_t>(shift);
}

}  // namespace

DepthMapping depth_mapping(DepthFormat format, const DepthFit& fit) {
  if (format == DepthFormat::z24) return linear_in_1_over_w(fit, 3 << 7, 3 << 8);  // 24.8: from 1.5 to 2^24 - 1.5
  // near / w. Near itself gets half a code less than the largest value, so that no rounding wraps.
  const std::int64_t near = kAllCodes - (std::int64_t{3} << 17);
  return {near, 0, near, 0};
}

DepthMapping depth_mapping_of_ranges(const DepthFit& fit) {
  const std::int64_t ratio = near_over_range(fit) >> 16;                    // 9.23
  constexpr std::int64_t kSpan = std::int64_t{kDepthRangeCodes - 3} << 16;  // 16.16 codes
  const std::int64_t quotient_at_far = (ratio * (kDepthRangeCodes - 3)) >> 7;
  return {quotient_at_far + kSpan, quotient_at_far - kDepthOfFar, kSpan, kDepthOfFar};
}

void change_depth_mapping(const DepthMapping& mapping, bool orthographic, DepthFit& fit, RasterOrigin& origin,
                          std::span<CompiledInstance> instances) {
  for (CompiledInstance& instance : instances) {
    if (!instance.visible) continue;
    if (orthographic) {
      const std::uint64_t range = std::uint64_t{instance.w_range} << instance.depth_normalisation;
      instance.depth_scale = static_cast<std::uint32_t>((static_cast<std::uint64_t>(mapping.span) << 31) / range);
    } else {
      scale_depth(instance, mapping.quotient_at_near, fit.quotient_at_near);
    }
  }
  fit.quotient_at_near = mapping.quotient_at_near;
  fit.offset = mapping.offset;
  origin.depth_offset = static_cast<std::uint32_t>(orthographic ? mapping.far : mapping.offset);
}

}  // namespace zstrip::detail
