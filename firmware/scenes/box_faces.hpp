// The six square faces of a box of 24 vertices, seen from outside (the cube) or from inside (the room).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "zstrip/scene.hpp"

namespace zstrip::scenes {

struct BoxFace {
  std::int8_t normal[3];
  std::int8_t right[3];  ///< the direction in which u grows
  std::int8_t up[3];     ///< the direction in which v grows
};
/// Normals +z, -z, +x, -x, +y, -y. Seen against the normal, the corners of a face are counter-clockwise from its lower
/// left.
inline constexpr BoxFace kBoxFaces[6] = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
                                         {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                         {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
inline constexpr int kCornerU[4] = {0, 1, 1, 0};
inline constexpr int kCornerV[4] = {0, 0, 1, 1};

/// `side` 1: faces look outwards; -1: inwards.
consteval std::array<Position, 24> box_positions(int side) {
  std::array<Position, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const BoxFace& face = kBoxFaces[i / 4];
    const int right = 2 * kCornerU[i % 4] - 1, up = 2 * kCornerV[i % 4] - 1;
    const auto corner = [&](int axis) {
      return static_cast<std::int16_t>(32767 *
                                       (side * face.normal[axis] + right * face.right[axis] + up * face.up[axis]));
    };
    result[i] = {corner(0), corner(1), corner(2)};
  }
  return result;
}

consteval std::array<Normal, 24> box_normals() {
  std::array<Normal, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto component = [&](int axis) {
      return static_cast<std::int8_t>(127 * kBoxFaces[i / 4].normal[axis]);
    };  // 1.7
    result[i] = {component(0), component(1), component(2), 0};
  }
  return result;
}

consteval std::array<Triangle, 12> box_triangles() {
  std::array<Triangle, 12> result{};
  for (std::size_t face = 0; face < 6; ++face) {
    const auto corner = [face](std::size_t i) { return static_cast<std::uint16_t>(4 * face + i); };
    result[2 * face] = {corner(0), corner(1), corner(2)};
    result[2 * face + 1] = {corner(0), corner(2), corner(3)};
  }
  return result;
}

}  // namespace zstrip::scenes
