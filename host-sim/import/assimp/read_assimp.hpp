// Reads a model file of any format of Assimp; glTF 2.0 has its own reader.
#pragma once

#include <filesystem>
#include <functional>

#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Has the same result as read_model. Calls `parsed` when Assimp has finished. The failure's message starts with a
/// verb. A lack of memory is std::bad_alloc.
Result<SourceModel> read_assimp(const std::filesystem::path& path, std::optional<UpAxis> up, Texcoords texcoords,
                                const std::function<void()>& parsed);

}  // namespace zstrip::sim
