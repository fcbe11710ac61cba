// Computes the flash of a scene, by kind of data, and the RAM of its skins and morph targets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "bake/baked_scene.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/clips.hpp"
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
  std::uint64_t joints = 0;     ///< with the joints' weights of each vertex
  std::uint64_t morphs = 0;     ///< offsets of morph targets
  std::uint64_t keyframes = 0;  ///< with tracks
  std::uint64_t tree = 0;       ///< for method::bsp
  std::uint64_t tables = 0;     ///< meshes, materials, textures, instances, lights, camera

  std::uint64_t arrays() const {
    return positions + normals + colours + texcoords + triangles + meshlets + edges + texels + joints + morphs +
           keyframes + tree;
  }
  std::uint64_t total() const { return arrays() + tables; }
};

/// Returns the bytes of the tables that hold pointers (meshes, textures, lines, edges, images, fonts and labels), with
/// addresses of 32 bits: the memory that a program lends for a blob.
std::uint64_t table_bytes(const Scene& scene);

/// Returns the flash of constants in a program with addresses of 32 bits, without the gaps of alignment.
FlashBytes flash_bytes(const Scene& scene, const Animation& animation, const BspTree& tree = {},
                       const BakedSkins& skins = {}, std::span<const DetailLevel> levels = {});

/// The RAM of skins and morph targets, in addition to the arena.
struct SkinRam {
  std::uint64_t vertices = 0;  ///< moved positions, normals and meshlets
  std::uint64_t joints = 0;    ///< poses and matrices
  std::uint64_t weights = 0;   ///< of morph targets

  std::uint64_t total() const { return vertices + joints + weights; }
};
SkinRam skin_ram(const BakedSkins& skins);
/// Returns the RAM of an open blob, without its tables: the rest of character_memory.
SkinRam skin_ram(std::span<const Skinning> skinnings, std::size_t joints, std::span<const MovedMorph> morphs,
                 std::size_t weights);

}  // namespace zstrip::sim
