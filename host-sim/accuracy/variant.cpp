// Flat materials, bilinear texels, meshes simplified by meshoptimizer, edges to blend.
#include "accuracy/variant.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <optional>

#include "import/meshlets.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kWorthSimplifying = 200;  // triangles

template <class T>
std::vector<T> copy(std::span<const T> from) {
  return {from.begin(), from.end()};
}

/// Keeps at most this percentage of the triangles, or more if the surface would move by more than a tenth of its size.
std::vector<unsigned> simplified_indices(const Mesh& mesh, std::uint32_t percent) {
  std::vector<unsigned> indices;
  for (const Triangle& t : mesh.triangles) indices.insert(indices.end(), {t.a, t.b, t.c});
  std::vector<std::array<float, 3>> points;
  for (const Position& p : mesh.positions) {
    points.push_back({static_cast<float>(p.x) * static_cast<float>(mesh.half_extent.x),
                      static_cast<float>(p.y) * static_cast<float>(mesh.half_extent.y),
                      static_cast<float>(p.z) * static_cast<float>(mesh.half_extent.z)});
  }
  const std::size_t wanted = mesh.triangles.size() * percent / 100 * 3;
  std::vector<unsigned> kept(indices.size());
  constexpr float kMaxError = 0.1F;
  kept.resize(meshopt_simplify(kept.data(), indices.data(), indices.size(), points[0].data(), points.size(),
                               sizeof points[0], wanted, kMaxError, 0, nullptr));
  return kept;
}

/// Returns the shading for smooth materials, if the settings change it.
std::optional<Shading> shading_of(const Settings& settings) {
  const std::string_view shading = settings.name_of(Knob::shading);
  if (shading == "flat") return Shading::flat;
  if (shading == "pixel") return Shading::pixel;
  return std::nullopt;
}

}  // namespace

bool may_simplify(const Scene& scene) {
  return std::ranges::any_of(scene.meshes, [](const Mesh& mesh) { return mesh.triangles.size() >= kWorthSimplifying; });
}

SceneVariant::SceneVariant(const Scene& scene, const Settings& settings)
    : fixed_range_(settings.name_of(Knob::fit) == "fixed"),
      textured_(scene, filters_mipmaps(settings) ? MipmapChoice::on : MipmapChoice::automatic),
      meshes_(copy(scene.meshes)),
      materials_(copy(textured_.scene().materials)),
      finishes_(copy(textured_.scene().finishes)) {
  if (const std::optional<Shading> shading = shading_of(settings)) {
    for (Material& material : materials_) {
      if (material.smooth == Shading::gouraud) material.smooth = *shading;
    }
  }
  if (filters_bilinearly(settings)) filter_bilinearly();
  if (const std::uint32_t percent = detail_percent(settings); percent != 100) simplify(percent);
  if (blends_edges(settings)) {
    Scene drawn = scene;
    drawn.meshes = meshes_;
    drawn.materials = materials_;
    edges_ = find_edges(drawn);
  }
}

void SceneVariant::simplify(std::uint32_t percent) {
  for (Mesh& mesh : meshes_) {
    if (mesh.triangles.size() < kWorthSimplifying) continue;
    const std::vector<unsigned> indices = simplified_indices(mesh, percent);
    const MeshData whole{copy(mesh.positions), copy(mesh.normals), copy(mesh.colours), copy(mesh.texcoords), {}, {}};
    std::vector<MeshData> parts = split_into_meshlets(whole, indices, mesh.half_extent);
    if (parts.size() != 1) continue;  // no triangles left, or more vertices than one mesh can have
    data_.push_back(std::move(parts[0]));
    // A mesh without meshlets remains so: the settings do not add meshlets.
    if (mesh.meshlets.empty()) data_.back().meshlets.clear();
    mesh = with_data(mesh, data_.back());
  }
}

void SceneVariant::filter_bilinearly() {
  const Scene& scene = textured_.scene();
  for (std::size_t i = 0; i < materials_.size(); ++i) {
    Material& material = materials_[i];
    const bool on_quadric =
        std::ranges::any_of(scene.quadrics, [i](const Quadric& quadric) { return quadric.material == i; });
    if (material.texture == kNoTexture || on_quadric || finishes_.size() >= kNoFinish) continue;
    Finish finish = finish_of(scene, material);
    finish.filter = TextureFilter::bilinear;
    material.finish = static_cast<std::uint8_t>(finishes_.size());
    finishes_.push_back(finish);
  }
}

Staging SceneVariant::apply(const Staging& staged) const {
  Staging result = staged;
  result.scene.textures = textured_.scene().textures;
  result.scene.meshes = meshes_;
  result.scene.materials = materials_;
  result.scene.finishes = finishes_;
  result.scene.edges = edges_.sets;
  result.camera.fixed_depth_range = fixed_range_;
  return result;
}

}  // namespace zstrip::sim
