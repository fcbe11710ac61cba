// STL as Assimp 5.2 reads it right.
#pragma once

#include <string>

namespace zstrip::sim {

/// In text nothing stands before "solid", and normals that are not numbers are zero: they are generated. A binary file
/// ends with its last triangle. Magics writes one colour for the whole into the header; triangles that refer to it get
/// it as their own.
std::string plain_stl(std::string bytes);

}  // namespace zstrip::sim
