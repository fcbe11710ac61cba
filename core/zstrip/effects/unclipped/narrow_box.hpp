// Finds if all that lies in the box of an instance is narrow, whatever its vertices are.
#pragma once

#include "zstrip/geometry/project.hpp"

namespace zstrip::detail::unclipped {

/// True: project_narrow takes every position, with any reciprocal. Its limits for x, y and w are linear in the
/// position, so that corners decide for the box.
template <bool orthographic>
bool is_box_narrow(const CompiledInstance& instance, const RasterOrigin& origin);

}  // namespace zstrip::detail::unclipped
