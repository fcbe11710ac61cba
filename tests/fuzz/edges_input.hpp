// Edges of a scene's meshes, to be anti-aliased, read from the fuzzer's bytes.
#pragma once

#include <vector>

#include "input.hpp"
#include "zstrip/scene.hpp"

namespace fuzz {

/// Sides of triangles, edges between any vertices, and some with vertices or of meshes that are not there.
struct EdgesInput {
  std::vector<std::vector<zstrip::Edge>> edges;
  std::vector<zstrip::EdgeSet> sets;

  EdgesInput(const zstrip::Scene& scene, Input& input) {
    const auto meshes = static_cast<std::uint32_t>(scene.meshes.size());
    std::uint32_t mesh = 0;
    for (std::uint32_t i = input.below(4); i > 0; --i) {
      mesh += input.below(meshes + 1);
      edges.push_back(mesh < meshes ? read(scene.meshes[mesh], input) : std::vector<zstrip::Edge>{});
      sets.push_back({.edges = {}, .mesh = static_cast<std::uint16_t>(mesh)});
      ++mesh;
    }
    for (std::size_t i = 0; i < sets.size(); ++i) sets[i].edges = edges[i];
  }

 private:
  static std::vector<zstrip::Edge> read(const zstrip::Mesh& mesh, Input& input) {
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    const std::uint32_t beyond = input.flag() && input.flag() ? 1 : 0;
    const auto vertex = [&] { return static_cast<std::uint16_t>(input.below(vertices + beyond)); };
    std::vector<zstrip::Edge> list(input.flag() ? input.below(100) : input.below(6));
    for (zstrip::Edge& edge : list) {
      const bool is_side = input.flag() && triangles != 0;
      if (is_side) {
        const zstrip::Triangle& t = mesh.triangles[input.below(triangles)];
        edge = {t.a, t.b, t.c};
        const std::uint32_t turn = input.below(6);
        if (turn % 3 == 1) edge = {t.b, t.c, t.a};
        if (turn % 3 == 2) edge = {t.c, t.a, t.b};
        if (turn >= 3) edge = {edge.b, edge.a, vertex(), edge.left};
      } else {
        edge = {vertex(), vertex(), vertex()};
      }
      if (input.flag() && edge.right == zstrip::kNoFace) edge.right = vertex();
    }
    return list;
  }
};

}  // namespace fuzz
