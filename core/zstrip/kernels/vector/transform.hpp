// Transforms a meshlet's vertices in vectors, with perspective and z16.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// True if the upper halves of the form's coefficients, rounded to nearest, have 16 bits, as SSE2 needs.
constexpr bool fits_vector(const LinearForm& form) {
  constexpr std::int32_t kLimit = 0x7FFF8000;
  return form.x < kLimit && form.y < kLimit && form.z < kLimit;
}
/// True if fits_vector is true for all forms, and FourShifts can do the shifts of coordinates.
constexpr bool fits_vector(const CompiledInstance& instance) {
  const auto fits = [](std::int32_t shift) { return shift >= 1 && shift <= 32; };
  return fits_vector(instance.w) && fits_vector(instance.x) && fits_vector(instance.y) && fits(instance.shift_x) &&
         fits(instance.shift_y);
}

/// Vertices that are transformed at once. Meshlets with fewer vertices are left to C++.
inline constexpr std::uint32_t kVectorVertices = 4;

/// Writes `count` >= kVectorVertices vertices; fits_vector must be true. Returns true if all are narrow.
bool transform_vertices_vector(const CompiledInstance& instance, const RasterOrigin& origin, const Position* positions,
                               std::uint32_t count, SnappedVertex* vertices);

}  // namespace zstrip::detail
