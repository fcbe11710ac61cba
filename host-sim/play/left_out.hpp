// The parts of the command that a page does without.
#pragma once

#include <optional>
#include <string_view>

#include "result.hpp"

namespace zstrip::sim {

/// Returns the reason why this scene, a word of a command line, is refused; nothing if it is accepted.
std::optional<Failure> left_out(std::string_view word);

}  // namespace zstrip::sim
