// The visibility methods: their options, what they count, potentially visible sets, and what lets AnyRenderer draw by
// them.
#pragma once

#include "zstrip/visibility/methods.hpp"
#include "zstrip/visibility/midpoint.hpp"
#include "zstrip/visibility/options.hpp"
#include "zstrip/visibility/stages.hpp"
#include "zstrip/visibility/visible_sets.hpp"

namespace zstrip {

/// From now on AnyRenderer draws by methods; without it, it refuses them with Error::visibility. Of the library
/// zstrip::methods. To be called once, before the first renderer is made, by one thread.
void use_visibility_methods();
/// As use_visibility_methods for method::culling alone: for programs that only count how often pixels are drawn. The
/// last of both calls holds.
void use_overdraw_counts();

}  // namespace zstrip
