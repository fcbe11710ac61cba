// A scene whose instances are drawn as the edges of their triangles.
#include "view/wireframe.hpp"

#include "compose/composed_lines.hpp"

namespace zstrip::sim {

Staging Wireframe::of(const Staging& staging) {
  const Scene& scene = staging.scene;
  materials_.assign(scene.materials.begin(), scene.materials.end());
  materials_.push_back({.lit = false});
  const auto wire = static_cast<std::uint16_t>(materials_.size() - 1);
  edges_.assign(scene.meshes.size(), {});
  lines_.assign(scene.lines.begin(), scene.lines.end());
  for (const Instance& instance : scene.instances) {
    std::vector<Segment>& edges = edges_[instance.mesh];
    if (edges.empty()) edges = edges_of(scene.meshes[instance.mesh]);
    lines_.push_back({.segments = edges, .mesh = instance.mesh, .material = wire, .transform = instance.transform});
  }
  Scene wires = scene;
  wires.materials = materials_;
  wires.lines = lines_;
  wires.instances = {};
  wires.edges = {};
  wires.csg = {};
  wires.shadow = nullptr;
  return {.scene = wires, .camera = staging.camera};
}

}  // namespace zstrip::sim
