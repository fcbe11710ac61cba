// A scene of which only the edges of its triangles are drawn.
#include "view/wireframe.hpp"

#include "compose/composed_lines.hpp"

namespace zstrip::sim {
namespace {

constexpr Material kWire{.lit = false};

}  // namespace

Staging Wireframe::of(const Staging& staging) {
  const Scene& scene = staging.scene;
  edges_.assign(scene.meshes.size(), {});
  lines_.clear();
  for (const Instance& instance : scene.instances) {
    std::vector<Segment>& edges = edges_[instance.mesh];
    if (edges.empty()) edges = edges_of(scene.meshes[instance.mesh]);
    lines_.push_back({.segments = edges, .mesh = instance.mesh, .transform = instance.transform});
  }
  Scene wires;
  wires.meshes = scene.meshes;
  wires.materials = {&kWire, 1};
  wires.outlines = scene.outlines;
  wires.lines = lines_;
  wires.overlay = scene.overlay;
  return {.scene = wires, .camera = staging.camera};
}

}  // namespace zstrip::sim
