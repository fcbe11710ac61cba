// Finds out if every position in the box of an instance is narrow.
#pragma once

#include "zstrip/geometry/project.hpp"

namespace zstrip::detail::unclipped {

/// True if project_narrow accepts every position, with any reciprocal. Its limits for x, y and w are linear in the
/// position, so that testing the corners of the box is enough.
template <bool orthographic>
bool is_box_narrow(const CompiledInstance& instance, const RasterOrigin& origin);

}  // namespace zstrip::detail::unclipped
