// Shapes that several folders' tests draw: meshes that own their memory, in the unit cube.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::test {

/// A mesh that owns its memory.
struct OwnMesh {
  std::vector<Position> positions;
  std::vector<Normal> normals;
  std::vector<Triangle> triangles;

  /// Of half extent 1; valid as long as this is.
  Mesh mesh() const {
    return {.positions = positions,
            .normals = normals,
            .colours = {},
            .texcoords = {},
            .triangles = triangles,
            .meshlets = {}};
  }
};

/// The unit sphere, vertices on its surface.
inline OwnMesh sphere(int rings, int segments) {
  OwnMesh own;
  for (int ring = 0; ring <= rings; ++ring) {
    for (int segment = 0; segment < segments; ++segment) {
      const double down = 3.14159265358979 * ring / rings, around = 2 * 3.14159265358979 * segment / segments;
      const std::array n{std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)};
      const auto place = [&n](std::size_t axis) { return static_cast<std::int16_t>(std::lround(32767 * n[axis])); };
      const auto normal = [&n](std::size_t axis) { return static_cast<std::int8_t>(std::lround(127 * n[axis])); };
      own.positions.push_back({place(0), place(1), place(2)});
      own.normals.push_back({normal(0), normal(1), normal(2), 0});
      if (ring == rings) continue;
      const int right = (segment + 1) % segments;
      const auto vertex = [segments](int r, int s) { return static_cast<std::uint16_t>(r * segments + s); };
      own.triangles.push_back({vertex(ring, segment), vertex(ring, right), vertex(ring + 1, right)});
      own.triangles.push_back({vertex(ring, segment), vertex(ring + 1, right), vertex(ring + 1, segment)});
    }
  }
  return own;
}

/// Each face has corners of its own.
inline OwnMesh faceted_box() {
  OwnMesh own;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const auto first = static_cast<std::uint16_t>(own.positions.size());
      for (const auto& [u, v] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        std::array<int, 3> p{};
        p[axis] = side;
        p[(axis + 1) % 3] = side * u;
        p[(axis + 2) % 3] = v;
        const auto place = [&p](std::size_t i) { return static_cast<std::int16_t>(32767 * p[i]); };
        own.positions.push_back({place(0), place(1), place(2)});
        std::array<std::int8_t, 3> n{};
        n[axis] = static_cast<std::int8_t>(127 * side);
        own.normals.push_back({n[0], n[1], n[2], 0});
      }
      const auto corner = [first](int i) { return static_cast<std::uint16_t>(first + i); };
      own.triangles.push_back({corner(0), corner(1), corner(2)});
      own.triangles.push_back({corner(0), corner(2), corner(3)});
    }
  }
  return own;
}

}  // namespace zstrip::test
