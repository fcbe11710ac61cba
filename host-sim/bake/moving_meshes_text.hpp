// The part of a baked header that moves vertices by joints and morph targets, in RAM.
#pragma once

#include <cstddef>
#include <string>

#include "bake/baked_scene.hpp"
#include "bake/header_text.hpp"

namespace zstrip::sim {

/// Returns the name of the function in a header that moves skins and morph targets before a frame.
const char* pose_function_of(const BakedSkins& skins);

/// Writes kMeshes, the table of `count` meshes that are drawn, and the tables that move some of them. `meshes`: the
/// literals of all at rest.
void add_moving_meshes(std::size_t count, const BakedSkins& skins, const std::string& meshes, HeaderText& out);

/// Writes the animations of weights and joints, and the functions that move the vertices to a time.
void add_motion(const BakedSkins& skins, HeaderText& out);

}  // namespace zstrip::sim
