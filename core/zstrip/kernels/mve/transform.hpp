// Transforms a meshlet's vertices four at a time in vectors of Helium, with perspective and z16.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// Vertices that are transformed at once. Thumb-2 transforms the meshlets with fewer vertices.
inline constexpr std::uint32_t kMveVertices = 4;

/// Writes `count` >= kMveVertices vertices. Returns true if all are narrow.
bool transform_vertices_mve(const CompiledInstance& instance, const RasterOrigin& origin, const Position* positions,
                            std::uint32_t count, SnappedVertex* vertices);

}  // namespace zstrip::detail
