// What is wrong with a command line that cannot be parsed, and what to type instead.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace zstrip::sim {

/// One line: of unknown options and commands the nearest known one, else the message of `error`; then where help is.
/// `app`: the one that threw `error`.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace zstrip::sim
