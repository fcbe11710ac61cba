// Files that a model names: exporters write paths of their own machine.
#pragma once

#include <filesystem>
#include <string>

namespace zstrip::sim {

/// The file beside the model that `name` means: as it stands, or, for paths of another machine, its last part. Upper
/// and lower case of the last part may differ.
std::filesystem::path find_file(const std::filesystem::path& folder, std::string name);

}  // namespace zstrip::sim
