// Reads a glTF 2.0 file from bytes, with a function that finds the files that it names. Does not access files itself.
#pragma once

#include "import/gltf/document.hpp"
#include "import/source_model.hpp"
#include "motion/affine.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// `turn` is applied after all nodes. Has the same result as read_model. The failure's message starts with a verb.
/// A lack of memory is std::bad_alloc.
Result<SourceModel> read_gltf(const GltfDocument& document, const ReadUri& read_uri, const Affine& turn,
                              Texcoords texcoords, Shine shine = {});

}  // namespace zstrip::sim
