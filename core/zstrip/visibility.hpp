// The visibility methods: their options, what they count, potentially visible sets, and what lets AnyRenderer draw by
// them.
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
/// Lets AnyRenderer draw with method::culling alone, for programs that only count how often pixels are drawn. It
/// replaces what use_visibility_methods has set, and the reverse.
void use_overdraw_counts();

}  // namespace zstrip
