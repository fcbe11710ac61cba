// The mappings from distance to depth of the formats other than z16. They replace that of a frame that has been
// prepared for z16, so that z16 carries nothing of them.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/geometry/project.hpp"
#include "zstrip/scene/depth_format.hpp"

namespace zstrip::detail {

/// log2 of the number of sub-ranges of effect::depth_ranges. Each has 2^(16 - this) codes.
inline constexpr int kLog2DepthRanges = 2;
inline constexpr std::uint32_t kDepthRanges = 1U << kLog2DepthRanges;
inline constexpr std::uint32_t kDepthRangeCodes = 1U << (16 - kLog2DepthRanges);

/// The depth that codes stand for: depth 1/2^32 of all codes, as project_depth gives it.
struct DepthMapping {
  std::int64_t quotient_at_near;  ///< k / near of depth = k / w - offset (perspective)
  std::int64_t offset;
  std::int64_t span;  ///< depth at near minus depth at far (orthographic)
  std::int64_t far;   ///< depth at far (orthographic)
};

/// For a range as DepthFit has it.
DepthMapping depth_mapping(DepthFormat format, const DepthFit& fit);
/// z16 in the lowest of the sub-ranges.
DepthMapping depth_mapping_of_ranges(const DepthFit& fit);

/// Gives fit, origin and instances of a frame prepared for z16 another mapping.
void change_depth_mapping(const DepthMapping& mapping, bool orthographic, DepthFit& fit, RasterOrigin& origin,
                          std::span<CompiledInstance> instances);

}  // namespace zstrip::detail
