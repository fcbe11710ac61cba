// Reads a glTF 2.0 file: bytes, and a function that finds what the file names. Knows of no files itself.
#pragma once

#include "import/gltf/document.hpp"
#include "import/source_model.hpp"
#include "motion/affine.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// `turn` comes after all nodes. What read_model promises of a model. The failure's message starts with a verb.
Result<SourceModel> read_gltf(const GltfDocument& document, const ReadUri& read_uri, const Affine& turn,
                              Texcoords texcoords, Highlights highlights = Highlights::none);

}  // namespace zstrip::sim
