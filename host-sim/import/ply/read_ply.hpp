// Reads a PLY file: vertices, faces and strips with their colours, edges, and clouds of points.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "image/rgb_image.hpp"
#include "import/source_model.hpp"
#include "motion/affine.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns the picture of a name in the file.
using ReadPicture = std::function<Result<RgbImage>(const std::string& name)>;

/// Reads elements `vertex`, `face`, `tristrips` and `edge`, in any order, of a file in text or bytes; others are
/// skipped. The time is proportional to the file's length, whatever its header says. `turn` is applied to all. A
/// failure's message starts with a verb.
Result<SourceModel> read_ply(std::string_view file, const ReadPicture& read_picture, const Affine& turn,
                             Texcoords texcoords);

}  // namespace zstrip::sim
