// Writes a scene as a C++ header of constants, which needs nothing but zstrip's core.
#pragma once

#include <string>

#include "bake/baked_scene.hpp"

namespace zstrip::sim {

inline constexpr const char* kDefaultNamespace = "baked";

/// Whether this can be the header's namespace: lower case letters, digits and single underscores between them, a letter
/// first, no namespace of zstrip or the library. (A keyword of C++ the compiler refuses.)
bool is_namespace(const std::string& name);

/// The same scene always gives the same text.
std::string to_scene_header(const BakedScene& baked, const std::string& name_space);

}  // namespace zstrip::sim
