// Prepares the CSG operands of a frame; only renderers with effect::csg link it.
#include "zstrip/effects/csg/operands.hpp"

#include "zstrip/effects/blending/draw_order.hpp"
#include "zstrip/geometry/meshlet_range.hpp"
#include "zstrip/state/bounds.hpp"

namespace zstrip::detail::csg {
namespace {

/// Returns the number of an instance's first meshlet, counted over all instances in drawing order.
std::uint32_t first_meshlet(const FrameState& frame, std::uint32_t instance) {
  const Scene& scene = *frame.scene;
  std::uint32_t first = 0;
  for (std::uint32_t place = 0; place < scene.instances.size(); ++place) {
    const std::uint32_t before = blending::instance_at(frame, place);
    if (before == instance) break;
    first += meshlet_count(scene.meshes[scene.instances[before].mesh]);
  }
  return first;
}

}  // namespace

Status check_memory(const FrameRequest& request, std::uint32_t cell_bytes) {
  const std::uint64_t cells = std::uint64_t{request.plan.strip_rows} * request.plan.strip_columns;
  const std::uint64_t needed =
      MemoryOfEffects::bytes(request.called_for, request.counts) + csg_strip_bytes(cells, cell_bytes);
  if (request.plan.effect_bytes >= needed) return {};
  return too_small(Purpose::effects, needed, request.plan.effect_bytes);
}

void prepare_operands(FrameState& frame, const Camera& camera) {
  const Scene& scene = *frame.scene;
  std::uint32_t largest = 0;
  for (std::size_t i = 0; i < scene.csg.size(); ++i) {
    const std::uint32_t index = scene.csg[i].instance;
    const Mesh& mesh = scene.meshes[scene.instances[index].mesh];
    if (mesh.meshlets.empty()) largest = std::max(largest, static_cast<std::uint32_t>(mesh.positions.size()));
    for (const Meshlet& meshlet : mesh.meshlets) largest = std::max<std::uint32_t>(largest, meshlet.vertex_count);
    CsgBounds& bounds = bounds_of(frame, i) = {};
    bounds.first_meshlet = first_meshlet(frame, index);
    const CompiledInstance& compiled = frame.instances[index];
    if (!compiled.visible) continue;
    const Rect box = bounds_of(compiled, frame.origin, frame.view, camera.projection == Projection::orthographic);
    bounds.left = static_cast<std::uint16_t>(box.left);
    bounds.top = static_cast<std::uint16_t>(box.top);
    bounds.right = static_cast<std::uint16_t>(box.right);
    bounds.bottom = static_cast<std::uint16_t>(box.bottom);
    const DistanceRange range = distance_range(mesh, scene.instances[index].transform, camera);
    bounds.cut = range.nearest < distance_of(camera.near_plane);
  }
  // If bins keep all vertices, the operands' vertices use the last part of that memory, because bins never keep them.
  state_of(frame) = {frame.plan.mode == Mode::binned ? count(scene).vertices - largest : 0, 0};
}

void hide_operands(FrameState& frame) {
  for (const CsgOperand& operand : frame.scene->csg) {
    frame.instances[operand.instance].visible = false;
    frame.instances[operand.instance].double_sided = false;
  }
}

}  // namespace zstrip::detail::csg
