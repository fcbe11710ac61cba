// The parts of the command that a page does without.
#pragma once

#include <optional>
#include <string_view>

#include "result.hpp"

namespace zstrip::sim {

/// Returns the reason why this word of a command line, a scene or an option, is refused; nothing if it is accepted.
std::optional<Failure> left_out(std::string_view word);

}  // namespace zstrip::sim
