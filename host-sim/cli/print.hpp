// Writes messages to stderr, always one line that starts with "zstrip: ".
#pragma once

#include <string_view>

#include "result.hpp"

namespace zstrip::sim {

/// Shows control characters, which names of files may contain, as '?'. If stderr is closed or full, the message is
/// lost.
void print_warning(std::string_view message);

/// Prints the message and returns the status as a number, for main's return value.
int print_failure(const Failure& failure);

}  // namespace zstrip::sim
