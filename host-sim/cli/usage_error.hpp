// Describes the error of a command line that cannot be parsed, and what to type instead.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace zstrip::sim {

/// Returns one line: for unknown options and commands the nearest known one, else the message of `error`; then how to
/// get help. `app`: the object that threw `error`.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace zstrip::sim
