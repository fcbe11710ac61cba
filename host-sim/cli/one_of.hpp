// Options whose value is one of a few known ones.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace zstrip::sim {

/// Takes these values as they are written here; the message about any other lists them and names the nearest.
/// Failures: ExitStatus::usage, as of all options. `values`: at least one.
CLI::Validator one_of(std::vector<std::string> values);

}  // namespace zstrip::sim
