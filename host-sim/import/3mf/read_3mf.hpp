// Reads a 3MF package: all objects that are built, from all its parts.
#pragma once

#include <string_view>

#include "import/source_model.hpp"
#include "motion/affine.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Reads the core of 3MF with its production extension (objects in other parts), base materials, colour groups and
/// textures. `turn` is applied to all. A failure's message starts with a verb.
Result<SourceModel> read_3mf(std::string_view file, const Affine& turn, Texcoords texcoords);

}  // namespace zstrip::sim
