// The format that a file's name tells.
#pragma once

#include <filesystem>
#include <string>

#include "text/text.hpp"

namespace zstrip::sim {

/// The extension with its dot, in lower case.
inline std::string ending_of(const std::filesystem::path& file) { return lower(file.extension().string()); }

}  // namespace zstrip::sim
