// Which effects a scene calls for, and what in it calls for each.
#include "bake/effects_found.hpp"

#include <fmt/format.h>

#include <set>

namespace zstrip::sim {
namespace {

constexpr KnownEffect kKnown[] = {
    {effect::lighting, "lighting", "lit, with normals"},
    {effect::gouraud, "gouraud", "smooth shading"},
    {effect::vertex_colours, "vertex_colours", "vertex colours"},
    {effect::textures, "textures", "a texture and texture coordinates"},
    {effect::orthographic, "orthographic", "the camera's parallel projection"},
    {effect::depth_state, "depth_state", "a depth test, depth write or bias of its own"},
    {effect::fog, "fog", "the scene's fog"},
    {effect::emissive, "emissive", "an emissive colour"},
    {effect::specular, "specular", "a specular colour"},
    {effect::punctual_lights, "punctual_lights", "lit, and there are point or spot lights"},
    {effect::alpha_test, "alpha_test", "the alpha mode mask"},
    {effect::blending, "blending", "the alpha mode blend"},
    {effect::texture_alpha, "texture_alpha", "a texture with alpha, masked or blended"},
    {effect::texture_palettes, "texture_palettes", "a texture with a palette"},
    {effect::mipmaps, "mipmaps", "a texture with mipmaps, and a finish"},
    {effect::bilinear, "bilinear", "the texture filter bilinear"},
    {effect::quadrics, "quadrics", "spheres and ellipsoids"},
    {effect::lines, "lines", "lines and points"},
    {effect::billboards, "billboards", "turns with the camera"},
    {effect::environment, "environment", "mirrors its surroundings, with normals"},
    {effect::outlines, "outlines", "has an outline"},
    {effect::shadows, "shadows", "the shadow of a light, and something is lit"},
    {effect::csg, "csg", "products of solids"},
    {effect::edges, "edges", "edges are anti-aliased (--edges)"},
    {effect::pixel_shading, "pixel_shading", "lit at pixels, with normals"},
    {effect::dithered_colours, "dithered_colours", "the picture is dithered to RGB565 (--dither)"},
    {effect::dithered_format, "dithered_format", "the picture is dithered to its format (--dither)"},
    {effect::supersampled, "supersampled", "the picture has several samples a pixel (--samples)"},
    {effect::bins, "bins", "the plan transforms geometry only once (--mode)"},
};

/// An effect that a scene or its picture can call for and that is not known here would be missing in headers and
/// reports.
constexpr bool all_known() {
  Effects known{};
  for (const KnownEffect& each : kKnown) known = known | each.effect;
  return known == (effect::of_scenes | effect::bins);
}
static_assert(all_known());

std::string name_of(std::uint16_t material, std::span<const std::string> names) {
  return material < names.size() && !names[material].empty() ? names[material] : fmt::format("number {}", material);
}

}  // namespace

std::span<const KnownEffect> known_effects() { return kKnown; }

std::vector<FoundEffect> find_effects(const Scene& scene, const Camera& camera, Effects effects,
                                      const Origins& origins) {
  std::vector<FoundEffect> found;
  for (const KnownEffect& known : kKnown) {
    if (!effects.has(known.effect)) continue;
    if ((effect::dithered_colours | effect::dithered_format | effect::supersampled | effect::edges).has(known.effect)) {
      found.push_back({known, {}, {}});
      continue;
    }
    const auto is_of_scene = [&](Effects effect, const std::string& origin) {
      if (known.effect == effect) found.push_back({known, {}, origin});
      return known.effect == effect;
    };
    if (is_of_scene(effect::fog, origins.fog) || is_of_scene(effect::orthographic, origins.camera) ||
        is_of_scene(effect::shadows, origins.shadow) || is_of_scene(effect::csg, origins.csg)) {
      continue;
    }
    FoundEffect effect{known, {}, {}};
    std::set<std::string> seen;
    const auto consider = [&](std::span<const Instance> instances, std::span<const Quadric> quadrics,
                              std::span<const LineSet> lines, std::uint16_t material) {
      Scene alone = scene;
      alone.instances = instances;
      alone.quadrics = quadrics;
      alone.lines = lines;
      if (!effects_of(alone, camera).has(known.effect)) return;
      const std::string name = name_of(material, origins.material_names);
      if (seen.empty() && material < origins.materials.size()) effect.origin = origins.materials[material];
      if (seen.insert(name).second) effect.materials.push_back(name);
    };
    for (const Instance& instance : scene.instances) consider({&instance, 1}, {}, {}, instance.material);
    for (const Quadric& quadric : scene.quadrics) consider({}, {&quadric, 1}, {}, quadric.material);
    for (const LineSet& lines : scene.lines) consider({}, {}, {&lines, 1}, lines.material);
    found.push_back(effect);
  }
  return found;
}

}  // namespace zstrip::sim
