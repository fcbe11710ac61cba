// Converts morph targets to fixed point.
#include "import/quantised_morphs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace zstrip::sim {
namespace {

/// Rounds to an integer within +-limit.
template <typename Integer>
Integer rounded(double value, double limit) {
  return static_cast<Integer>(std::lround(std::clamp(value, -limit, limit)));
}

MorphOffset to_offset(const Grid& grid, const std::array<float, 3>& from) {
  const auto component = [&](float value) { return rounded<std::int16_t>(grid.steps_of(double{value}), 32767); };
  return {component(from[0]), component(from[1]), component(from[2])};
}

NormalOffset to_normal_offset(const std::array<float, 3>& from) {
  const auto component = [](float value) { return rounded<std::int8_t>(double{value} * 127 / 2, 127); };
  return {component(from[0]), component(from[1]), component(from[2])};
}

/// A target of a mesh while its vertices are visited in order.
struct OpenTarget {
  MorphTables tables;
  bool moves_normals = false;

  void add(std::size_t vertex, const MorphOffset& position, const NormalOffset& normal) {
    const auto index = static_cast<std::uint16_t>(vertex);
    if (tables.runs.empty() || tables.runs.back().first_vertex + tables.runs.back().count != index) {
      tables.runs.push_back(
          {.first_vertex = index, .count = 0, .first_offset = static_cast<std::uint16_t>(tables.positions.size())});
    }
    ++tables.runs.back().count;
    tables.positions.push_back(position);
    tables.normals.push_back(normal);
    moves_normals = moves_normals || normal.x != 0 || normal.y != 0 || normal.z != 0;
  }
};

}  // namespace

SourceBox places_of(const SourceModel& source, const SourceVertex& vertex) {
  SourceBox box;
  include(box, place_of(source, vertex));
  if (vertex.morph == 0) return box;
  for (const SourceMorphOffset& offset : source.morphs[vertex.morph - 1]) {
    const SourceWeight& weight = source.weights[offset.weight];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double one = weight.low * double{offset.position[axis]},
                   other = weight.high * double{offset.position[axis]};
      box.low[axis] += std::min({one, other, 0.0});
      box.high[axis] += std::max({one, other, 0.0});
    }
  }
  return box;
}

SourceBox box_of_morphs(const SourceModel& source, const SourceMesh& mesh) {
  SourceBox box;
  for (const SourceVertex& vertex : mesh.vertices) {
    for_each_place(source, vertex, [&](const Vector& place) { include(box, place); });
  }
  return box;
}

double longest_offset(const SourceModel& source, const SourceMesh& mesh) {
  double longest = 0;
  for (const SourceVertex& vertex : mesh.vertices) {
    if (vertex.morph == 0) continue;
    for (const SourceMorphOffset& offset : source.morphs[vertex.morph - 1]) {
      for (const float component : offset.position) longest = std::max(longest, std::abs(double{component}));
    }
  }
  return longest;
}

void add_morph(const SourceModel& source, const Grid& grid, const std::vector<std::uint32_t>& vertices, Model& model) {
  std::map<std::uint32_t, OpenTarget> targets;  // by weight
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i] == 0) continue;
    for (const SourceMorphOffset& offset : source.morphs[vertices[i] - 1]) {
      const MorphOffset position = to_offset(grid, offset.position);
      const NormalOffset normal = to_normal_offset(offset.normal);
      const bool stays = position.x == 0 && position.y == 0 && position.z == 0;
      if (stays && normal.x == 0 && normal.y == 0 && normal.z == 0) continue;
      targets[offset.weight].add(i, position, normal);
      double& reach = model.weights[offset.weight].reach;
      const auto& [x, y, z] = offset.position;
      reach = std::max(reach, std::hypot(double{x}, double{y}, double{z}) * grid.units.scale);
    }
  }
  if (targets.empty()) return;
  ModelMorph& morph = model.morphs.emplace_back();
  morph.mesh = model.meshes.size() - 1;
  morph.base = model.meshes.back();
  for (auto& [weight, target] : targets) {
    if (!target.moves_normals) target.tables.normals.clear();
    const MorphTables& tables = model.morph_tables.emplace_back(std::move(target.tables));
    morph.targets.push_back({.weight = static_cast<std::uint16_t>(weight),
                             .runs = tables.runs,
                             .positions = tables.positions,
                             .normals = tables.normals});
  }
}

}  // namespace zstrip::sim
