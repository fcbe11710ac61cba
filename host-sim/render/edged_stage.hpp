// A stage that adds anti-aliased edges to all meshes of its scene, or removes them.
#pragma once

#include <memory>
#include <optional>

#include "render/stage.hpp"

namespace zstrip::sim {

/// `edges`: true adds the edges of all meshes with instances to a scene that has none, false removes the edges of a
/// baked scene, nothing changes nothing. Fails if the stage cannot be placed; a usage error if pictures of `view` have
/// several samples, or the scene has effects that edges cannot be combined with.
Result<std::unique_ptr<Stage>> with_edges(std::unique_ptr<Stage> stage, std::optional<bool> edges, const View& view);

}  // namespace zstrip::sim
