// The transform of a meshlet's vertices in vectors, with perspective and z16.
#pragma once

#include <cstdint>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/processor.hpp"

namespace zstrip::detail {

/// Whether the upper halves of the form's coefficients, rounded to nearest, have 16 bits, which SSE2 needs.
constexpr bool fits_vector(const LinearForm& form) {
  constexpr std::int32_t kLimit = 0x7FFF8000;
  return form.x < kLimit && form.y < kLimit && form.z < kLimit;
}

/// Writes `count` vertices. Returns whether all are narrow. For instances whose three forms fit.
bool transform_vertices_vector(const CompiledInstance& instance, const RasterOrigin& origin, const Position* positions,
                               std::uint32_t count, SnappedVertex* vertices);

}  // namespace zstrip::detail
