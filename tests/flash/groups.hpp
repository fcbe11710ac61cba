// What code and constants of a program are for, by the names of functions and objects: the one table of patterns.
#pragma once

#include <cstddef>
#include <string>

namespace zstrip::flash {

enum class Group : std::size_t {
  clipping,
  set_up,
  spans,
  small_triangles,
  vertices,
  frame,
  resolve,
  checks,
  texts,
  library,
  rest,
};

/// In the order of Group.
struct GroupName {
  const char* column;  ///< of the table
  const char* words;   ///< for readers
};
inline constexpr GroupName kGroups[] = {
    {"clipping", "clipping, and polygons that it makes"},
    {"set_up", "set-up of instances and camera"},
    {"spans", "spans: set-up of triangles, rows, texels"},
    {"small_triangles", "small triangles"},
    {"vertices", "vertices"},
    {"frame", "frame and strips, `main`"},
    {"resolve", "resolve and pixel formats"},
    {"checks", "checks"},
    {"texts", "texts of errors"},
    {"library", "arithmetic, C library, libgcc"},
    {"rest", "the rest"},
};

/// `name` is what the linker calls a function or object. No pattern: Group::rest.
Group group_of(const std::string& name);

/// Whether an object is a table of the scene, which is not counted; else it is a constant of the renderer.
bool is_table(const std::string& name);

}  // namespace zstrip::flash
