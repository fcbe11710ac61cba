// Programs that show a baked scene by zstrip::Player: a sketch for Arduino, a source for CMake. Both include the
// scene's header by the name scene.hpp.
#pragma once

#include <string>

#include "bake/baked_scene.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// ExitStatus::usage for what a player does not draw, a method of visibility, and for a namespace with a name of the
/// program's own.
Result<Done> check_for_program(const BakedScene& baked, const std::string& name_space);
/// The same of a sketch, and for a picture that no ST7789 shows.
Result<Done> check_for_sketch(const BakedScene& baked, const std::string& name_space);

/// Of the header with that namespace. The same scene always gives the same text.
std::string to_sketch(const BakedScene& baked, const std::string& name_space);
/// `file`: its name, which its CMakeLists.txt has.
std::string to_program(const BakedScene& baked, const std::string& name_space, const std::string& file);

}  // namespace zstrip::sim
