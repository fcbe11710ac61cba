// A file of a folder that `zstrip bake` writes.
#pragma once

#include <string>

namespace zstrip::sim {

struct ProjectFile {
  std::string name;  ///< its path in the folder
  std::string text;
};

}  // namespace zstrip::sim
