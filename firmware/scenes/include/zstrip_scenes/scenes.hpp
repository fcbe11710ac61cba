// The catalogue of all built-in scenes. It links all of them: firmware with a single scene includes that scene's header
// instead.
#pragma once

#include <span>
#include <string_view>

#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::scenes {

/// Returns all scenes, from small to large, in static storage.
std::span<const BuiltIn> built_in();

/// Returns the scene with exactly this name, or nullptr.
const BuiltIn* find(std::string_view name);

}  // namespace zstrip::scenes
