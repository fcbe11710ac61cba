// Options whose value is one of a few known words, in upper or lower case.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace zstrip::sim {

/// Accepts these values in any case and passes them on as they are written here; the message about any other lists
/// them and names the nearest. Failures: ExitStatus::usage, as of all options. `values`: at least one, no two of which
/// differ in case alone.
CLI::Validator one_of(std::vector<std::string> values);

/// Passes the value on in lower case: for options whose words all are, and are read later.
CLI::Validator lower_case();

}  // namespace zstrip::sim
