// Converts OBJ and its materials to a form that Assimp 5.2 reads correctly.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace zstrip::sim {

/// True if the comments at the beginning of an OBJ or MTL text name Blender, whose colours are linear.
bool is_of_blender(std::string_view text);

/// The colour of a vertex without one, in a file where other vertices have one.
inline constexpr float kNoColour = -1;

/// Texture coordinates of a material: those of vertices times `scale`, plus `move`.
struct TexturePlace {
  std::array<double, 2> scale{1, 1}, move{0, 0};
  friend bool operator==(const TexturePlace&, const TexturePlace&) = default;
};

/// Names of an OBJ file's materials.
struct ObjMaterials {
  std::set<std::string> used, defined;
  std::map<std::string, TexturePlace> places;  ///< of those whose textures are scaled or moved
};

/// In the result all vertices have 3 or 4 numbers, or all have 3 and a colour. Texture coordinates have 2 or 3; faces
/// and lines name none if the file has none. Numbers have a leading zero, and no comment after them, names no spaces
/// after them. Each file of materials has a line of its own: `is_file` says if there is a file of this name. Materials
/// of faces and lines are added to `used`. Positions too far away for floats get an origin of their own, which is
/// returned in `origin`.
std::string plain_obj(std::string_view from, const std::function<bool(std::string_view)>& is_file,
                      std::set<std::string>& used, std::array<double, 3>& origin);

/// Returns an MTL with only the lines that are drawn: names, diffuse colours and textures, alpha, illumination. Assimp
/// refuses a file for some of the others. `linear`: diffuse colours are linear; otherwise is_of_blender() decides.
/// Without a colour a texture is shown unchanged. Warnings are added to `warnings`, names and places to `materials`.
std::string plain_mtl(std::string_view text, bool linear, std::vector<std::string>& warnings, ObjMaterials& materials);

}  // namespace zstrip::sim
