// Writes a scene as a blob that open_scene_blob uses in place; the format is in docs/formats.md.
#pragma once

#include <cstdint>
#include <vector>

#include "result.hpp"
#include "zstrip/blob.hpp"

namespace zstrip::sim {

/// Equal scenes, cameras and views give equal bytes. Skins are of meshes of content.scene as they were modelled, in
/// their order; `moved` is not read. Fails only above 4 GB.
Result<std::vector<std::uint8_t>> to_scene_blob(const SceneBlob& content);

}  // namespace zstrip::sim
