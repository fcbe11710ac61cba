// OBJ and its materials as Assimp 5.2 reads them right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace zstrip::sim {

/// Whether the comments that a text of OBJ or MTL begins with name Blender, whose colours are linear.
bool is_of_blender(std::string_view text);

/// The colour of a vertex without one, in a file that has others with one.
inline constexpr float kNoColour = -1;

/// Vertices have 3 or 4 numbers, or 3 and a colour, all or none of them. Texture coordinates have 2 or 3. Numbers have
/// a leading zero, names no spaces behind them.
std::string plain_obj(std::string_view from);

/// MTL of the lines that are drawn: names, diffuse colours and textures, illumination. Assimp refuses a file for some
/// of the others. `linear`: the diffuse colours are; else is_of_blender() says it. Without a colour a texture is seen
/// as it is. `warnings`: is added to.
std::string plain_mtl(std::string_view text, bool linear, std::vector<std::string>& warnings);

}  // namespace zstrip::sim
