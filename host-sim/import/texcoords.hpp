// Fits texture coordinates of any size into 16 bits.
#pragma once

#include <cstdint>

#include "import/source_model.hpp"

namespace zstrip::sim {

inline constexpr int kMaxTexcoordBits = 15;
inline constexpr int kMinTexcoordBits = 4;

/// Moves the coordinates of `mesh` by whole textures towards zero and returns the number of fraction bits that then
/// fit, 4..15. If the whole mesh leaves a resolution of less than a quarter of a texel (`log2_side`: of the texture's
/// longer side), each triangle is moved separately; such a mesh then has three separate vertices for each triangle.
/// `clamped` counts the vertices of triangles that are so large that even 4 bits do not fit.
int fit_texcoords(SourceMesh& mesh, int log2_side, std::uint64_t& clamped);

/// The longest sides, as powers of two, of a texture with these coordinates and fraction bits: the renderer counts
/// texels in 16 bits and a sign, so that no coordinate may reach 32768 texels.
struct TextureSides {
  int log2_width = 15;
  int log2_height = 15;
};
TextureSides longest_sides(const SourceMesh& mesh, int bits);

}  // namespace zstrip::sim
