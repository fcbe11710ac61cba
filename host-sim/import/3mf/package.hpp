// The parts of a 3MF package that are drawn: objects, their colours, and where they are built.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "motion/affine.hpp"
#include "result.hpp"

namespace zstrip::sim {

inline constexpr std::uint32_t kNoProperty = 0xFFFFFFFF;

/// A triangle, with a property group of its part and an index in that for each corner.
struct PrintTriangle {
  std::array<std::uint32_t, 3> corners{};
  std::uint32_t group = kNoProperty;
  std::array<std::uint32_t, 3> properties{};
};

/// The use of an object: as a part of another object, or as one that is printed.
struct PrintUse {
  std::string part;  ///< empty: the part that has the use
  std::uint32_t object = 0;
  Affine place;
};

struct PrintObject {
  std::vector<Vector> vertices;
  std::vector<PrintTriangle> triangles;
  std::vector<PrintUse> components;
};

enum class PrintGroupKind : std::uint8_t { materials, colours, texture };

/// Properties that triangles refer to by index.
struct PrintGroup {
  PrintGroupKind kind = PrintGroupKind::colours;
  std::vector<std::string> names;                    ///< of materials, as many as colours
  std::vector<std::array<std::uint8_t, 4>> colours;  ///< of materials and colours
  std::vector<std::array<double, 2>> texcoords;      ///< of a texture; v grows upwards
  std::uint32_t texture = kNoProperty;               ///< in PrintPart::textures
};

/// A .model file of the package.
struct PrintPart {
  std::map<std::uint32_t, PrintObject> objects;
  std::map<std::uint32_t, PrintGroup> groups;
  std::map<std::uint32_t, std::string> textures;  ///< paths in the package
  std::vector<PrintUse> built;
  std::set<std::string> undrawn;  ///< names of what it has besides
};

/// Reads the text of a .model file. Properties stand in groups of their kind, and resources of a kind have different
/// ids; groups and textures without an id are left out. The failure's message is a reason.
Result<PrintPart> read_print_part(std::string_view xml);

}  // namespace zstrip::sim
