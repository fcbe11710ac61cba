// What Assimp leaves out of files without a word.
#pragma once

#include <filesystem>

#include "import/model_files.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Adds warnings for files of materials that OBJ names and that are not there, and for edges of PLY; and those
/// of `files`.
void warn_of_unread(const std::filesystem::path& path, const FilesRead& files, SourceModel& model);

}  // namespace zstrip::sim
