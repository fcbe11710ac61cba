// A stage whose scene has the edges of all its meshes, to be anti-aliased, or none.
#pragma once

#include <memory>
#include <optional>

#include "render/stage.hpp"

namespace zstrip::sim {

/// `edges`: true adds those of all meshes that instances have to a scene without any, false takes away what a baked
/// scene has, nothing leaves it as it is. Fails where the stage cannot be placed, and a usage error where pictures of
/// `view` have several samples, or the scene has what edges do not go with.
Result<std::unique_ptr<Stage>> with_edges(std::unique_ptr<Stage> stage, std::optional<bool> edges, const View& view);

}  // namespace zstrip::sim
