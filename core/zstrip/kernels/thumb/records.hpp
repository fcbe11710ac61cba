// What the assembly, in Thumb-1 and Thumb-2, expects of the records of a scene, of transformed vertices and of numbers.
#pragma once

#include <cstddef>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

static_assert(sizeof(Position) == 6 && offsetof(Position, y) == 2 && offsetof(Position, z) == 4);
static_assert(sizeof(Triangle) == 6 && offsetof(Triangle, b) == 2 && offsetof(Triangle, c) == 4);
static_assert(sizeof(Colour) == 4 && offsetof(Colour, r) == 0 && offsetof(Colour, g) == 1 && offsetof(Colour, b) == 2);
static_assert(sizeof(SnappedVertex) == 8 && offsetof(SnappedVertex, x) == 0 && offsetof(SnappedVertex, y) == 2 &&
              offsetof(SnappedVertex, depth) == 4);
static_assert(kPixelCentre == 15 && kNarrowLimit == 1 << 14 && kNotNarrow == -0x8000);
static_assert(snap_depth(0xFFFFFFFF) == 0xFFFFE000 && snap_depth(0) == 0x2000);

#endif

}  // namespace zstrip::detail
