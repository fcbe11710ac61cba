// What a scene takes of the flash, by kind, and its skins of the RAM.
#pragma once

#include <cstdint>

#include "bake/baked_scene.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"

namespace zstrip::sim {

struct FlashBytes {
  std::uint64_t positions = 0;
  std::uint64_t normals = 0;
  std::uint64_t colours = 0;
  std::uint64_t texcoords = 0;
  std::uint64_t triangles = 0;
  std::uint64_t meshlets = 0;
  std::uint64_t edges = 0;
  std::uint64_t texels = 0;
  std::uint64_t joints = 0;     ///< and what each moves of a vertex
  std::uint64_t keyframes = 0;  ///< and tracks
  std::uint64_t tree = 0;       ///< of method::bsp
  std::uint64_t tables = 0;     ///< meshes, materials, textures, instances, lights, camera

  std::uint64_t arrays() const {
    return positions + normals + colours + texcoords + triangles + meshlets + edges + texels + joints + keyframes +
           tree;
  }
  std::uint64_t total() const { return arrays() + tables; }
};

/// The tables of meshes, textures, lines, edges, images, fonts and labels, which hold pointers, with addresses of 32
/// bits: what a program lends for a blob.
std::uint64_t table_bytes(const Scene& scene);

/// As constants of a program for a processor with addresses of 32 bits, without what alignment adds.
FlashBytes flash_bytes(const Scene& scene, const Animation& animation, const BspTree& tree = {},
                       const BakedSkins& skins = {});

/// What skins take of the RAM beside the arena.
struct SkinRam {
  std::uint64_t vertices = 0;  ///< moved positions, normals and meshlets
  std::uint64_t joints = 0;    ///< poses and matrices
};
SkinRam skin_ram(const BakedSkins& skins);

}  // namespace zstrip::sim
