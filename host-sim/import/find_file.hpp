// Finds files that a model names: exporters write paths of their own machine.
#pragma once

#include <filesystem>
#include <string>

namespace zstrip::sim {

/// Returns the file next to the model with the name `name`, or, for paths of another machine, with its last part. Upper
/// and lower case of the last part may differ.
std::filesystem::path find_file(const std::filesystem::path& folder, std::string name);

}  // namespace zstrip::sim
