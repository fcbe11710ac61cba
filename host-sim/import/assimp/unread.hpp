// Warns of parts of files that Assimp ignores without a message.
#pragma once

#include <filesystem>

#include "import/model_files.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Adds warnings for missing files of materials that OBJ names, for curves and solids of DXF, and those of `files`.
void warn_of_unread(const std::filesystem::path& path, const FilesRead& files, SourceModel& model);

}  // namespace zstrip::sim
