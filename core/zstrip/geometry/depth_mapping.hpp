// The mappings from distance to depth for formats other than z16. They replace the mapping of a frame that was prepared
// for z16, so that renderers with z16 have no code for them.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/geometry/project.hpp"
#include "zstrip/scene/depth_format.hpp"

namespace zstrip::detail {

/// log2 of the number of sub-ranges of effect::depth_ranges. Each has 2^(16 - kLog2DepthRanges) codes.
inline constexpr int kLog2DepthRanges = 2;
inline constexpr std::uint32_t kDepthRanges = 1U << kLog2DepthRanges;
inline constexpr std::uint32_t kDepthRangeCodes = 1U << (16 - kLog2DepthRanges);

/// A mapping from distance to depth. Depth is in 1/2^32 of all codes, as in project_depth.
struct DepthMapping {
  std::int64_t quotient_at_near;  ///< k / near, for depth = k / w - offset (perspective)
  std::int64_t offset;
  std::int64_t span;  ///< depth at near minus depth at far (orthographic)
  std::int64_t far;   ///< depth at far (orthographic)
};

DepthMapping depth_mapping(DepthFormat format, const DepthFit& fit);
/// Returns the mapping of z16 to the lowest sub-range.
DepthMapping depth_mapping_of_ranges(const DepthFit& fit);

/// Changes fit, origin and instances of a frame that was prepared for z16 to another mapping.
void change_depth_mapping(const DepthMapping& mapping, bool orthographic, DepthFit& fit, RasterOrigin& origin,
                          std::span<CompiledInstance> instances);

}  // namespace zstrip::detail
