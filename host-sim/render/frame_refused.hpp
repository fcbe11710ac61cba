// Explains a status of the renderer in terms of the command line.
#pragma once

#include <string_view>

#include "result.hpp"
#include "zstrip/status.hpp"

namespace zstrip::sim {

/// `what` ("the frame cannot begin") failed because of `status`, which must not be success. The cause selects the exit
/// status: a baked scene's own camera or transforms (input), too little memory allowed, in the plan or in a shadow's
/// pool (budget), or else a bug (internal). Thread-safe.
Failure frame_refused(std::string_view what, const Status& status);

}  // namespace zstrip::sim
