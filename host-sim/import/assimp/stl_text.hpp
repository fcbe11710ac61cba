// Converts STL to a form that Assimp 5.2 reads correctly.
#pragma once

#include <string>

namespace zstrip::sim {

/// Text begins with "solid", and invalid normals become zero: they are generated later. A binary file ends with its
/// last triangle. Magics writes one colour for the whole model into the header; triangles that refer to it get it as
/// their own.
std::string plain_stl(std::string bytes);

}  // namespace zstrip::sim
