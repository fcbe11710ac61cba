// What a status of the renderer means in terms of the command line.
#pragma once

#include <string_view>

#include "result.hpp"
#include "zstrip/status.hpp"

namespace zstrip::sim {

/// `what` could not be done ("the frame cannot begin") because of `status`, which is none of success. Whose fault it is
/// decides the exit status: a baked scene's own camera or transforms (input), too little memory allowed, in the plan or
/// in a shadow's pool (budget), or else a bug (internal). Thread-safe.
Failure frame_refused(std::string_view what, const Status& status);

}  // namespace zstrip::sim
