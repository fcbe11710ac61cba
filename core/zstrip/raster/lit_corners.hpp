// Normals and positions of the corners of triangles that are lit at their pixels.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/effects/local_light/local_light.hpp"
#include "zstrip/raster/attributes.hpp"
#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/raster/space_planes.hpp"

namespace zstrip::detail {

struct LitCorner {
  Vector3 normal{};  ///< 1.21, with the length of the mesh's normal; in world space with local light, else in object
                     ///< space
  Vector3 place{};   ///< WorldPoint; only with local light
};

/// The surface of one triangle.
struct LitSurface : Surface {
  LitCorner corners[3];  ///< set if the instance has_lit_fragments
  explicit LitSurface(const Surface& surface) : Surface(surface) {}
};

/// The surface of triangles whose fragments have effects.
template <Effects effects>
using FragmentSurface = std::conditional_t<effects.has(effect::pixel_shading), LitSurface, Surface>;

/// Returns the corner for a vertex of the mesh.
template <Effects effects>
LitCorner lit_corner(const Mesh& mesh, std::uint32_t vertex, const PixelLightSettings& settings) {
  const Normal& n = mesh.normals[vertex];
  if constexpr (effects.any(effect::local_light)) {
    if (settings.shading != nullptr) {
      const InstanceShading& shading = *settings.shading;
      const Position& p = mesh.positions[vertex];
      const auto turned = [&](int row) {  // 1.7 times 1.14
        return n.x * shading.normal[row][0] + n.y * shading.normal[row][1] + n.z * shading.normal[row][2];
      };
      return {{turned(0), turned(1), turned(2)}, {shading.x.at(p), shading.y.at(p), shading.z.at(p)}};
    }
  }
  return {{n.x * (1 << 14), n.y * (1 << 14), n.z * (1 << 14)}, {}};
}

/// While a triangle is clipped, its vertices hold weights of its three corners instead of colours; this is weight 1.
inline constexpr std::int32_t kWholeCorner = 1 << 30;

template <class Vertex>
void set_corner(Vertex& vertex, int corner) {
  vertex.r = corner == 0 ? kWholeCorner : 0;
  vertex.g = corner == 1 ? kWholeCorner : 0;
  vertex.b = corner == 2 ? kWholeCorner : 0;
}

/// Returns the weighted sum of values of the corners at a clipped vertex: three terms of 30 and 31 bits, below 2^62.
inline std::int32_t mixed_by(const RasterVertex& vertex, std::int32_t a, std::int32_t b, std::int32_t c) {
  return static_cast<std::int32_t>(
      (std::int64_t{a} * vertex.r + std::int64_t{b} * vertex.g + std::int64_t{c} * vertex.b) >> 30);
}
inline Vector3 mixed_by(const RasterVertex& vertex, const Vector3& a, const Vector3& b, const Vector3& c) {
  return {mixed_by(vertex, a.x, b.x, c.x), mixed_by(vertex, a.y, b.y, c.y), mixed_by(vertex, a.z, b.z, c.z)};
}

/// Computes the corners and the colours of one triangle of a clipped triangle, from the whole triangle's corners.
inline void take_corners(RasterVertex (&vertices)[3], const LitCorner (&of)[3], const RasterVertex (&colours)[3],
                         LitSurface& surface) {
  for (int i = 0; i < 3; ++i) {
    RasterVertex& vertex = vertices[i];
    surface.corners[i] = {mixed_by(vertex, of[0].normal, of[1].normal, of[2].normal),
                          mixed_by(vertex, of[0].place, of[1].place, of[2].place)};
    const std::int32_t r = mixed_by(vertex, colours[0].r, colours[1].r, colours[2].r);
    const std::int32_t g = mixed_by(vertex, colours[0].g, colours[1].g, colours[2].g);
    vertex.b = mixed_by(vertex, colours[0].b, colours[1].b, colours[2].b);
    vertex.r = r, vertex.g = g;
  }
}

}  // namespace zstrip::detail
