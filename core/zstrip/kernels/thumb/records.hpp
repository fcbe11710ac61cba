// The layout of a scene's records, of transformed vertices and of pixels, for assembly.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/thumb/layout.hpp"
#include "zstrip/scene.hpp"

// clang-format off
#define ZSTRIP_RECORDS(field, number)           \
  field(position, Position, x, 0)               \
  field(position, Position, y, 2)               \
  field(position, Position, z, 4)               \
  number(position.size, sizeof(Position), 6)    \
  field(triangle, Triangle, a, 0)               \
  field(triangle, Triangle, b, 2)               \
  field(triangle, Triangle, c, 4)               \
  number(triangle.size, sizeof(Triangle), 6)    \
  field(colour, Colour, r, 0)                   \
  field(colour, Colour, g, 1)                   \
  field(colour, Colour, b, 2)                   \
  number(colour.size, sizeof(Colour), 4)        \
  field(vertex, SnappedVertex, x, 0)            \
  field(vertex, SnappedVertex, y, 2)            \
  field(vertex, SnappedVertex, depth, 4)        \
  number(vertex.size, sizeof(SnappedVertex), 8) \
  number(cell, sizeof(std::uint16_t), 2) /* of depth, and a pixel */
// clang-format on

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

ZSTRIP_CHECK_LAYOUT(ZSTRIP_RECORDS)
static_assert(kPixelCentre == 15 && kNarrowLimit == 1 << 14 && kNotNarrow == -0x8000);
static_assert(snap_depth(0xFFFFFFFF) == 0xFFFFE000 && snap_depth(0) == 0x2000);

#endif

}  // namespace zstrip::detail
