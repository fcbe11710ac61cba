// The visibility method of a baked scene: which outputs keep it, and what it excludes.
#pragma once

#include <string>

#include "bake/baked_scene.hpp"
#include "cli/bake_kind.hpp"
#include "render/stage.hpp"
#include "visibility/prepared_scene.hpp"

namespace zstrip::sim {

/// A method that the output does not keep is refused as an option. From a scene file it becomes a warning, and `method`
/// is cleared: memory is planned with a z-buffer.
Result<Done> settle_method(BakeKind kind, const std::string& scene, bool is_option, Effects& method);

/// Prepares the scene for its method, without which it stays as it is. Prepared scenes and visible sets are only for
/// scenes that do not move: else a usage error.
Result<PreparedScene> prepare_for(Effects method, bool has_visible_sets, const Staging& staging,
                                  const Animation& animation, const BakedSkins& skins);

/// Returns the motion of the one instance that the method makes of all instances: they rotate together, or not at all.
/// A scene sorted for one camera does not move: with `turntable` a usage error, else a warning.
Result<Turn> turn_of(const Stage& stage, Effects method, bool turntable, const Staging& original);

}  // namespace zstrip::sim
