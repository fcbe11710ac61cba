// The knot with its edges, all of them smooth.
#pragma once

#include <array>
#include <cstddef>

#include "zstrip_scenes/knot.hpp"

namespace zstrip::scenes {

/// Of the closed grid of knot.cpp: the three edges of each quad's first triangle.
inline constexpr auto kKnotEdgeList = [] {
  const auto index = [](std::size_t ring, std::size_t side) {
    return static_cast<std::uint16_t>(ring % kKnotRings * kKnotRingVertices + side % kKnotRingVertices);
  };
  const auto smooth = [](const Edge& edge) {
    return edge.a < edge.b ? edge : Edge{edge.b, edge.a, edge.right, edge.left};
  };
  std::array<Edge, 3 * kKnotVertices> edges{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < kKnotRings; ++i) {
    for (std::size_t j = 0; j < kKnotRingVertices; ++j) {
      const std::uint16_t a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      edges[next++] = smooth({a, c, b, d});
      edges[next++] = smooth({b, a, c, index(i, j + kKnotRingVertices - 1)});
      edges[next++] = smooth({c, b, a, index(i + 2, j + 1)});
    }
  }
  return edges;
}();
inline constexpr EdgeSet kKnotEdges[1] = {{.edges = kKnotEdgeList, .mesh = 0}};

inline constexpr BuiltIn edges = [] {
  BuiltIn scene = knot;
  scene.name = "edges";
  scene.scene.edges = kKnotEdges;
  scene.counts = count(scene.scene);
  return scene;
}();

}  // namespace zstrip::scenes
