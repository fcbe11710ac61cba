// Which effects a scene calls for, and what in it calls for each.
#include "bake/effects_found.hpp"

#include <fmt/format.h>

#include <set>

namespace zstrip::sim {
namespace {

struct Known {
  Effects effect;
  const char* name;
  const char* reason;
};
constexpr Known kMaterialEffects[] = {
    {effect::lighting, "lighting", "lit, with normals"},
    {effect::gouraud, "gouraud", "smooth shading"},
    {effect::vertex_colours, "vertex_colours", "vertex colours"},
    {effect::textures, "textures", "a texture and texture coordinates"},
    {effect::depth_state, "depth_state", "a depth test, depth write or bias of its own"},
};

std::string name_of(std::uint16_t material, std::span<const std::string> names) {
  return material < names.size() && !names[material].empty() ? names[material] : fmt::format("number {}", material);
}

}  // namespace

std::vector<FoundEffect> find_effects(const Scene& scene, const Camera& camera,
                                      std::span<const std::string> material_names) {
  std::vector<FoundEffect> found;
  for (const Known& known : kMaterialEffects) {
    FoundEffect effect{known.effect, known.name, known.reason, {}};
    std::set<std::string> seen;
    for (const Instance& instance : scene.instances) {
      Scene alone = scene;
      alone.instances = {&instance, 1};
      if (!effects_of(alone, camera).has(known.effect)) continue;
      const std::string name = name_of(instance.material, material_names);
      if (seen.insert(name).second) effect.materials.push_back(name);
    }
    if (!effect.materials.empty()) found.push_back(effect);
  }
  if (effects_of(scene, camera).has(effect::orthographic)) {
    found.push_back({effect::orthographic, "orthographic", "the camera's parallel projection", {}});
  }
  return found;
}

}  // namespace zstrip::sim
