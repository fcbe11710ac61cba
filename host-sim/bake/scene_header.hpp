// Writes a scene as a C++ header of constants, which needs only zstrip's core.
#pragma once

#include <string>

#include "bake/baked_scene.hpp"

namespace zstrip::sim {

inline constexpr const char* kDefaultNamespace = "baked";

/// True if this can be the header's namespace: lower case letters, digits and single underscores between them, a letter
/// first, not a namespace of zstrip or the library. (The compiler refuses keywords of C++.)
bool is_namespace(const std::string& name);

/// Equal scenes give equal text.
std::string to_scene_header(const BakedScene& baked, const std::string& name_space);

}  // namespace zstrip::sim
