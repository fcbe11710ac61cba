// Options whose value is one of a few known words, in upper or lower case.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace zstrip::sim {

/// Accepts these values in any case and returns them as they are written here. For another value the message lists them
/// and names the nearest. Failures: ExitStatus::usage, as for all options. `values`: at least one; no two may differ
/// only in case.
CLI::Validator one_of(std::vector<std::string> values);

/// Converts the value to lower case: for options with lower case words that are read later.
CLI::Validator lower_case();

}  // namespace zstrip::sim
