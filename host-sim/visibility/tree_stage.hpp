// A stage with the tree of painter-bsp, which is made once: its frames are those of the scene that `zstrip bake` makes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/scene/turn.hpp"

namespace zstrip::sim {

/// How the one instance of a tree turns where the stage's `instances` do; none if some of them move and others do not.
std::optional<Turn> turn_of_tree(const Stage& stage, std::size_t instances);

/// Splits and lights the scene as it stands in frame 0 of `frames`; in later ones the light turns with it. A stage
/// without turn_of_tree, or with a tree, is returned as it is. A failure: that of PreparedScene, for method::bsp.
Result<std::unique_ptr<Stage>> with_tree(std::unique_ptr<Stage> stage, std::uint32_t frames);

}  // namespace zstrip::sim
