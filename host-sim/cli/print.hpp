// What the command writes to stderr, always one line starting with "zstrip: ".
#pragma once

#include <string_view>

#include "result.hpp"

namespace zstrip::sim {

/// Control characters, which names of files may hold, are shown as '?'. Where stderr is closed or full, nothing is
/// said.
void print_warning(std::string_view message);

/// Prints the message and returns the status as a number, for main's return value.
int print_failure(const Failure& failure);

}  // namespace zstrip::sim
