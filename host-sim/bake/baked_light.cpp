// The light of each vertex is computed as a device computes it.
#include "bake/baked_light.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "zstrip/geometry/shade_vertices.hpp"

namespace zstrip::sim {
namespace {

bool can_hold_light(const Scene& scene, const Mesh& mesh, const Material& material) {
  if (!material.lit || mesh.normals.empty() || material.smooth == Shading::pixel) return false;
  if (material.texture != kNoTexture && !mesh.texcoords.empty()) return false;
  if (mesh.billboard != Billboard::none || mesh.outline != 0 || mesh.skinning != nullptr) return false;
  if (material.finish == kNoFinish) return true;
  const Finish& finish = scene.finishes[material.finish];
  // An unlit material of another alpha multiplies colours of vertices, which rounds them.
  if (finish.alpha_mode != AlphaMode::opaque && material.colour.a != 255) return false;
  constexpr Colour kBlack{0, 0, 0, 255};
  return finish.emissive == kBlack && finish.specular == kBlack && !is_environment(finish.filter);
}

std::vector<Colour> lit_colours(const Scene& scene, const Instance& instance) {
  const Mesh& mesh = scene.meshes[instance.mesh];
  detail::CompiledInstance compiled;
  // Light does not depend on the camera. In a depth range that ends before it begins nothing is seen, and nothing
  // fails. A picture without rows would have no scale.
  constexpr View kOnePixel{1, 1};
  constexpr DepthFit kNothing{.near = 1, .far = 0, .quotient_at_near = 0, .offset = 0};
  static_cast<void>(compile_instance(compiled, scene, instance, Camera{}, kOnePixel, kNothing));
  std::vector<Colour> colours(mesh.positions.size());
  detail::shade_vertices<effect::lighting | effect::vertex_colours>(
      compiled, mesh, 0, static_cast<std::uint32_t>(colours.size()), colours.data());
  return colours;
}

}  // namespace

LightBakedScene::LightBakedScene(const Scene& scene, std::set<std::size_t> kept)
    : scene_(scene),
      meshes_(scene.meshes.begin(), scene.meshes.end()),
      materials_(scene.materials.begin(), scene.materials.end()),
      instances_(scene.instances.begin(), scene.instances.end()) {
  constexpr std::size_t kMaxMaterials = 0x7FFF;  // each may get a copy
  if (scene.materials.size() > kMaxMaterials) return;
  if (!scene.punctual_lights.empty() || scene.shadow != nullptr || !scene.csg.empty()) return;
  for (const LineSet& lines : scene.lines) kept.insert(lines.mesh);
  for (const Outline& outline : scene.outlines) kept.insert(outline.hull);
  std::map<std::size_t, std::vector<Colour>> lit;  // by mesh
  for (const Instance& instance : scene.instances) {
    if (kept.contains(instance.mesh)) continue;
    if (!can_hold_light(scene, scene.meshes[instance.mesh], scene.materials[instance.material])) {
      kept.insert(instance.mesh);
      continue;
    }
    std::vector<Colour> colours = lit_colours(scene, instance);
    const auto [known, is_new] = lit.try_emplace(instance.mesh, std::move(colours));
    if (!is_new && known->second != colours) kept.insert(instance.mesh);
  }
  for (auto& [mesh, colours] : lit) {
    if (kept.contains(mesh)) continue;
    meshes_[mesh].normals = {};
    meshes_[mesh].colours = colours_.emplace_back(std::move(colours));
  }
  std::set<std::size_t> shared;  // materials of what stays lit
  for (const Instance& instance : instances_) {
    if (kept.contains(instance.mesh)) shared.insert(instance.material);
  }
  for (const Quadric& quadric : scene.quadrics) shared.insert(quadric.material);
  for (const LineSet& lines : scene.lines) shared.insert(lines.material);
  std::map<std::size_t, std::uint16_t> unlit;  // by material
  for (Instance& instance : instances_) {
    if (kept.contains(instance.mesh)) continue;
    ++baked_;
    const auto [known, is_new] = unlit.try_emplace(instance.material, instance.material);
    if (is_new) {
      if (shared.contains(instance.material)) {
        known->second = static_cast<std::uint16_t>(materials_.size());
        materials_.emplace_back(materials_[instance.material]);
      }
      Material& material = materials_[known->second];
      material.lit = false;
      material.colour = {255, 255, 255, 255};
    }
    instance.material = known->second;
  }
  scene_.meshes = meshes_;
  scene_.materials = materials_;
  scene_.instances = instances_;
}

}  // namespace zstrip::sim
