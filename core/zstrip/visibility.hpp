// The visibility methods: options, statistics, potentially visible sets, and the functions that enable them in
// AnyRenderer.
#pragma once

#include "zstrip/visibility/methods.hpp"
#include "zstrip/visibility/midpoint.hpp"
#include "zstrip/visibility/options.hpp"
#include "zstrip/visibility/stages.hpp"
#include "zstrip/visibility/visible_sets.hpp"

namespace zstrip {

/// Lets AnyRenderer draw by methods, which it refuses with Error::visibility before this call. Needs the library
/// zstrip::methods. Call it once, before the first renderer is made, from one thread.
void use_visibility_methods();
/// Lets AnyRenderer draw with method::culling alone, for programs that only count how often pixels are drawn. It and
/// use_visibility_methods replace each other's setting.
void use_overdraw_counts();

}  // namespace zstrip
