// Calls to a debugger or an emulator. Without one, a call is a fault, so that only programs for one may call.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace zstrip::board {

/// Writes the words that the host passes to the program, separated by spaces, into `buffer`. Returns none if there are
/// no words or they do not fit.
std::optional<std::string_view> read_command_line(std::span<char> buffer);

[[noreturn]] void exit_emulator(int status);

}  // namespace zstrip::board
