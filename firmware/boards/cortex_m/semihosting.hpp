// Calls to a debugger or an emulator. Without one, a call is a fault: only for programs made to run under one.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace zstrip::board {

/// The words that the host passes to the program, separated by spaces, in `buffer`. Nothing if the host has none or
/// they do not fit.
std::optional<std::string_view> read_command_line(std::span<char> buffer);

/// Ends the emulator with this exit status.
[[noreturn]] void exit_emulator(int status);

}  // namespace zstrip::board
