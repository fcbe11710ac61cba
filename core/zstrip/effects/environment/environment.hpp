// Environment maps: computes the texture coordinates of a vertex on a sphere map. docs/conventions.md has the formula.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/base/unit_vector.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/plan/record_bytes.hpp"

namespace zstrip::detail {

/// Values for an instance's vertices: the camera's axes (x to the right, y up, z back) in the mesh's space.
struct EyeForms {
  LinearForm x, y, z;         ///< vector from a position to the eye, of any scale, below 2^30
  std::int16_t normal[3][3];  ///< rows, 1.14: object to view, without scale
  std::int16_t unused;
};

EyeForms eye_forms(const Mesh& mesh, const Transform& transform, const Camera& camera);

/// A point of a sphere map relative to its middle, 1.14, to the right and up; at most about 1 away from it.
struct MirroredPoint {
  std::int32_t x, y;
};

/// Returns the point at which the ball has the vertex's normal, in the frame of the line from the vertex to the eye:
/// the camera's axes rotated the shortest way. A normal that points away from the eye is mirrored on the rim; on a
/// two-sided surface the normal of the other side is used.
template <bool orthographic>
constexpr MirroredPoint mirrored_point(const EyeForms& forms, const Position& position, const Normal& normal,
                                       bool double_sided) {
  const auto turned = [&](int row) {  // 1.7 times 1.14, three products: below 2^23
    return normal.x * forms.normal[row][0] + normal.y * forms.normal[row][1] + normal.z * forms.normal[row][2];
  };
  const UnitVector n = direction_of(turned(0), turned(1), turned(2)).unit;
  MirroredPoint point{n.x, n.y};
  std::int32_t towards = n.z;  // 1.14: cosine of the angle between normal and line of sight
  if constexpr (!orthographic) {
    // Behind the camera's plane the line of sight is put into that plane: no vertex there is visible.
    const UnitVector eye =
        direction_of(forms.x.at(position), forms.y.at(position), std::max<std::int32_t>(forms.z.at(position), 0)).unit;
    towards = dot(n, eye) >> 14;
    const std::int32_t share = (towards + n.z) * (1 << 14) / ((1 << 14) + eye.z);  // 2.14, because eye.z >= 0
    point.x -= (eye.x * share) >> 14;
    point.y -= (eye.y * share) >> 14;
  }
  if (towards >= 0) return point;
  if (double_sided) return {-point.x, -point.y};
  const UnitVector rim = direction_of(point.x, point.y, 0).unit;
  return {rim.x, rim.y};
}

/// Returns coordinates with 15 fraction bits. The ball's rim goes through the middle of the outermost texels, so that
/// no texel is repeated.
constexpr TexCoord texcoord_of(const MirroredPoint& point, std::uint8_t log2_width, std::uint8_t log2_height) {
  const auto coordinate = [](std::int32_t c, std::uint8_t log2_size) {
    return static_cast<std::int16_t>((1 << 14) + c - (c >> log2_size));
  };
  return {coordinate(point.x, log2_width), coordinate(-point.y, log2_height)};
}

}  // namespace zstrip::detail
