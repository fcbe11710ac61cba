// Converts OBJ and its materials to a form that Assimp 5.2 reads correctly.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace zstrip::sim {

/// True if the comments at the beginning of an OBJ or MTL text name Blender, whose colours are linear.
bool is_of_blender(std::string_view text);

/// The colour of a vertex without one, in a file where other vertices have one.
inline constexpr float kNoColour = -1;

/// In the result all vertices have 3 or 4 numbers, or all have 3 and a colour. Texture coordinates have 2 or 3. Numbers
/// have a leading zero, names no spaces after them.
std::string plain_obj(std::string_view from);

/// Returns an MTL with only the lines that are drawn: names, diffuse colours and textures, illumination. Assimp refuses
/// a file for some of the others. `linear`: diffuse colours are linear; otherwise is_of_blender() decides. Without a
/// colour a texture is shown unchanged. Warnings are added to `warnings`.
std::string plain_mtl(std::string_view text, bool linear, std::vector<std::string>& warnings);

}  // namespace zstrip::sim
