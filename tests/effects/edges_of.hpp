// The edges of a test's mesh, found by the places of its corners.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "zstrip/scene.hpp"

namespace effects_test {

/// `is_crease(first triangle, second)`: whether shading breaks where they meet. Of meshes in which no edge has more
/// than two faces.
template <class IsCrease>
std::vector<zstrip::Edge> edges_of_mesh(const zstrip::Mesh& mesh, const IsCrease& is_crease) {
  using Place = std::array<int, 3>;
  const auto place = [&mesh](std::uint16_t vertex) {
    const zstrip::Position& p = mesh.positions[vertex];
    return Place{p.x, p.y, p.z};
  };
  struct Side {
    std::uint16_t a, b, third;
    std::size_t triangle;
  };
  std::map<std::array<Place, 2>, std::vector<Side>> sides;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const zstrip::Triangle& t = mesh.triangles[i];
    for (const auto& [a, b, c] : {std::array{t.a, t.b, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}}) {
      sides[{std::min(place(a), place(b)), std::max(place(a), place(b))}].push_back({a, b, c, i});
    }
  }
  std::vector<zstrip::Edge> edges;
  for (const auto& [ends, found] : sides) {
    zstrip::Edge edge{found[0].a, found[0].b, found[0].third};
    if (found.size() == 2) {
      edge.right = found[1].third;
      if ((edge.a > edge.b) != is_crease(found[0].triangle, found[1].triangle)) {
        edge = {edge.b, edge.a, edge.right, edge.left};
      }
    }
    edges.push_back(edge);
  }
  return edges;
}

}  // namespace effects_test
