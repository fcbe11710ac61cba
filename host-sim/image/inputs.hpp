// The files that this process has read, which it must not overwrite.
#pragma once

#include <filesystem>

#include "result.hpp"

namespace zstrip::sim {

/// Safe on several threads, as check_no_input is.
void remember_input(const std::filesystem::path& path);

/// Refuses an output that is a remembered file, by any of its names: relative, or a symbolic link. `option` is the
/// option that selects another place.
Result<Done> check_no_input(const std::filesystem::path& path, const char* option);

}  // namespace zstrip::sim
