// Adds front faces to the lists of their strips, in assembly for Cortex-M.
#pragma once

#include <cstdint>

#include "zstrip/kernels/portable/list_faces.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

bool list_faces_thumb(FaceLists& faces, const Triangle* triangles, std::uint32_t count);

}  // namespace zstrip::detail
