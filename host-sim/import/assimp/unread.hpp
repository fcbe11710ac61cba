// What Assimp leaves out of files without a word.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Adds warnings for files of materials that OBJ names and that are not there, and for edges of PLY. `not_opened`: what
/// Assimp asked for in vain.
void warn_of_unread(const std::filesystem::path& path, const std::vector<std::string>& not_opened, SourceModel& model);

}  // namespace zstrip::sim
