// Fits texture coordinates of any size into 16 bits.
#include "import/texcoords.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace zstrip::sim {
namespace {

/// Subtracts, on each axis, the integer nearest to the middle of its range, which does not change the picture.
void centre(std::span<SourceVertex> vertices) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax_element(
        vertices.begin(), vertices.end(),
        [axis](const SourceVertex& a, const SourceVertex& b) { return a.texcoord[axis] < b.texcoord[axis]; });
    const float shift = std::floor((low->texcoord[axis] + high->texcoord[axis]) / 2);
    for (SourceVertex& vertex : vertices) vertex.texcoord[axis] = vertex.texcoord[axis] - shift + 0.0F;
  }
}

int fitting_bits(std::span<const SourceVertex> vertices) {
  float largest = 0;
  for (const SourceVertex& vertex : vertices) {
    largest = std::max({largest, std::abs(vertex.texcoord[0]), std::abs(vertex.texcoord[1])});
  }
  int bits = kMaxTexcoordBits;
  while (bits > kMinTexcoordBits && std::ldexp(largest, bits) > 32767) --bits;
  return bits;
}

}  // namespace

int fit_texcoords(SourceMesh& mesh, int log2_side, std::uint64_t& clamped) {
  centre(mesh.vertices);
  int bits = fitting_bits(mesh.vertices);
  if (bits < std::min(log2_side + 2, kMaxTexcoordBits - 2)) {
    std::vector<SourceVertex> own;
    own.reserve(mesh.indices.size());
    for (const std::uint32_t index : mesh.indices) own.push_back(mesh.vertices[index]);
    for (std::size_t i = 0; i < own.size(); i += 3) centre({own.data() + i, 3});
    mesh.vertices = std::move(own);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0U);
    bits = fitting_bits(mesh.vertices);
  }
  const float limit = std::ldexp(32767.0F, -bits);
  for (SourceVertex& vertex : mesh.vertices) {
    if (std::abs(vertex.texcoord[0]) <= limit && std::abs(vertex.texcoord[1]) <= limit) continue;
    ++clamped;
    for (float& value : vertex.texcoord) value = std::clamp(value, -limit, limit);
  }
  return bits;
}

TextureSides longest_sides(const SourceMesh& mesh, int bits) {
  const auto longest = [&](std::size_t axis) {
    double largest = 0;  // after rounding
    for (const SourceVertex& vertex : mesh.vertices) {
      largest = std::max(largest, std::round(std::ldexp(std::abs(double{vertex.texcoord[axis]}), bits)));
    }
    int log2_side = 15;
    while (log2_side > 0 && std::ldexp(largest, log2_side - bits) >= 32768) --log2_side;
    return log2_side;
  };
  return {longest(0), longest(1)};
}

}  // namespace zstrip::sim
