// Reads a model file of any format that Assimp knows; glTF 2.0 has a reader of its own.
#pragma once

#include <filesystem>
#include <functional>

#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// What read_model promises of a model. `parsed` is called once Assimp has done its part. The failure's message starts
/// with a verb.
Result<SourceModel> read_assimp(const std::filesystem::path& path, std::optional<UpAxis> up, Texcoords texcoords,
                                const std::function<void()>& parsed);

}  // namespace zstrip::sim
