// The format of a file by its name.
#pragma once

#include <filesystem>
#include <string>

#include "text/text.hpp"

namespace zstrip::sim {

/// Returns the extension with its dot, in lower case.
inline std::string ending_of(const std::filesystem::path& file) { return lower(file.extension().string()); }

}  // namespace zstrip::sim
