// How a glTF 2.0 file interpolates its animations, which Assimp does not report.
#pragma once

#include <filesystem>

#include "motion/node_tree.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The interpolations of one node's curves, by the node's name as Assimp gives it.
struct NodeInterpolation {
  std::string node;
  Interpolation translation = Interpolation::linear;
  Interpolation rotation = Interpolation::linear;
  Interpolation scale = Interpolation::linear;
};

/// Of each animation, in the file's order; fewer, or none, where the file has none or is damaged.
std::vector<std::vector<NodeInterpolation>> read_interpolations(const std::filesystem::path& path);

}  // namespace zstrip::sim
