// The parts of the command that a page does without.
#pragma once

#include <optional>
#include <string_view>

#include "result.hpp"

namespace zstrip::sim {

/// Why this word of a command line, a scene, is refused; nothing if it is not.
std::optional<Failure> left_out(std::string_view word);

}  // namespace zstrip::sim
