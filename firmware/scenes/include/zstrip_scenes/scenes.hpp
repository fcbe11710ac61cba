// The catalogue of all built-in scenes. Links every one of them: firmware that shows a single scene includes that
// scene's own header instead.
#pragma once

#include <span>
#include <string_view>

#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::scenes {

/// All scenes, from small to large, in static storage.
std::span<const BuiltIn> built_in();

/// The scene of this exact name, or nullptr.
const BuiltIn* find(std::string_view name);

}  // namespace zstrip::scenes
