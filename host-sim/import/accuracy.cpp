// Measures the error of a model's numbers in fixed point against the file's numbers.
#include "import/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "import/quantise.hpp"

namespace zstrip::sim {
namespace {

/// Returns degrees between two directions; also exact for tiny angles. 0 if one of them is zero.
double angle_between(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const std::array<double, 3> cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return std::atan2(std::hypot(cross[0], cross[1], cross[2]), dot) * 180 / std::numbers::pi;
}

}  // namespace

void note_vertices(Accuracy& worst, const SourceMesh& source, const MeshData& fixed, const Grid& grid) {
  const Vec3 &centre = grid.centre, &half_extent = grid.half_extent;
  for (std::size_t i = 0; i < source.vertices.size(); ++i) {
    const SourceVertex& from = source.vertices[i];
    const Position& p = fixed.positions[i];
    const auto off = [&](std::size_t axis, std::int16_t steps, Fixed middle, Fixed half) {
      const double scene = from_fixed(middle) + from_fixed(half) * steps / 32768;  // 1.15 of the half extent
      const double origin = grid.units.origin[axis] - grid.vertices_from[axis];
      return scene / grid.units.scale + origin - double{from.position[axis]};
    };
    worst.position =
        std::max(worst.position, std::hypot(off(0, p.x, centre.x, half_extent.x), off(1, p.y, centre.y, half_extent.y),
                                            off(2, p.z, centre.z, half_extent.z)));
    const Normal& n = fixed.normals[i];
    worst.normal = std::max(
        worst.normal, angle_between({double{from.normal[0]}, double{from.normal[1]}, double{from.normal[2]}},
                                    {static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)}));
  }
}

void note_texcoords(Accuracy& worst, const SourceMesh& source, const MeshData& fixed, int bits,
                    const RgbImage& texture) {
  for (std::size_t i = 0; i < source.vertices.size(); ++i) {
    const auto off = [&](std::size_t axis, std::int16_t steps, std::uint32_t side) {
      return std::abs(std::ldexp(static_cast<double>(steps), -bits) - double{source.vertices[i].texcoord[axis]}) * side;
    };
    const TexCoord& t = fixed.texcoords[i];
    worst.texcoord = std::max({worst.texcoord, off(0, t.u, texture.width), off(1, t.v, texture.height)});
  }
}

void note_texels(Accuracy& worst, const RgbImage& image, std::span<const std::uint16_t> texels) {
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const auto off = [&](std::size_t channel, int level, int levels) {
      return std::abs(static_cast<double>(level) / levels - image.rgb[3 * i + channel] / 255.0);
    };
    const std::uint16_t texel = texels[i];
    worst.texel =
        std::max({worst.texel, off(0, texel >> 11, 31), off(1, texel >> 5 & 0x3F, 63), off(2, texel & 0x1F, 31)});
  }
}

}  // namespace zstrip::sim
