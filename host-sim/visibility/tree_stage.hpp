// A stage with the tree of painter-bsp, which is made once: its frames equal those of the scene that `zstrip bake`
// makes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/scene/turn.hpp"

namespace zstrip::sim {

/// Returns the motion of a tree's one instance that corresponds to the motion of the stage's `instances`; none if some
/// of them move and others do not.
std::optional<Turn> turn_of_tree(const Stage& stage, std::size_t instances);

/// Splits and lights the scene as it is in frame 0 of `frames`; in later frames the light rotates with the scene.
/// Returns a stage without turn_of_tree, or with a tree, unchanged. Failures: those of PreparedScene, for method::bsp.
Result<std::unique_ptr<Stage>> with_tree(std::unique_ptr<Stage> stage, std::uint32_t frames);

}  // namespace zstrip::sim
