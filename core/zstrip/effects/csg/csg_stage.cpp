// Prepares the products of solids of a frame; only renderers with effect::csg link it.
#include "zstrip/effects/csg/csg_stage.hpp"

#include "zstrip/stages/bounds.hpp"

namespace zstrip::detail::csg {
namespace {

/// Of an instance, among those of all instances in the order of drawing.
std::uint32_t first_meshlet(const Scene& scene, const EffectBlock& block, std::uint32_t instance) {
  const bool has_order = block.has(effect::blending);
  std::uint32_t first = 0;
  for (std::uint32_t place = 0; place < scene.instances.size(); ++place) {
    const std::uint32_t before = has_order ? block.order()[place].instance : place;
    if (before == instance) break;
    const std::size_t meshlets = scene.meshes[scene.instances[before].mesh].meshlets.size();
    first += meshlets == 0 ? 1 : static_cast<std::uint32_t>(meshlets);
  }
  return first;
}

}  // namespace

Status check_memory(const FrameRequest& request, std::uint32_t cell_bytes) {
  const std::uint64_t cells = std::uint64_t{request.plan.strip_rows} * request.plan.strip_columns;
  const std::uint64_t needed =
      effect_bytes(request.called_for, count(request.scene)) + csg_strip_bytes(cells, cell_bytes);
  if (request.plan.effect_bytes >= needed) return {};
  return too_small(Purpose::effects, needed, request.plan.effect_bytes);
}

void Stage::prepare_operands(FrameState& frame, const Camera& camera) {
  const Scene& scene = *frame.scene;
  const EffectBlock block = effect_block(frame);
  std::uint32_t largest = 0;
  for (std::size_t i = 0; i < scene.csg.size(); ++i) {
    const std::uint32_t index = scene.csg[i].instance;
    const Mesh& mesh = scene.meshes[scene.instances[index].mesh];
    if (mesh.meshlets.empty()) largest = std::max(largest, static_cast<std::uint32_t>(mesh.positions.size()));
    for (const Meshlet& meshlet : mesh.meshlets) largest = std::max<std::uint32_t>(largest, meshlet.vertex_count);
    CsgBounds& bounds = block.csg_bounds(i) = {};
    bounds.first_meshlet = first_meshlet(scene, block, index);
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
  // Where bins keep all vertices, those of operands are not among them: their room is the last.
  block.csg() = {frame.plan.mode == Mode::binned ? count(scene).vertices - largest : 0, 0};
}

void Stage::hide_operands(FrameState& frame) {
  for (const CsgOperand& operand : frame.scene->csg) {
    frame.instances[operand.instance].visible = false;
    frame.instances[operand.instance].double_sided = false;
  }
}

void Stage::turn_normals(const FrameState& frame, std::uint32_t instance) {
  const auto turn = [](std::int16_t& component) { component = static_cast<std::int16_t>(-component); };
  const EffectBlock block = effect_block(frame);
  for (ObjectLight& light : frame.instances[instance].lights) {
    turn(light.x), turn(light.y), turn(light.z);
  }
  const auto turn_rows = [&turn](auto& rows) {
    for (auto& row : rows) {
      for (std::int16_t& component : row) turn(component);
    }
  };
  if (block.has(effect::local_light)) turn_rows(block.shading(instance).normal);
  if (block.has(effect::environment)) turn_rows(block.eye_forms(instance).normal);
}

}  // namespace zstrip::detail::csg
