// Workload K5, the scene knot, drawn by firmware with and without each effect: which programs there are, and which two
// of them are compared.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "zstrip/visibility.hpp"
#include "zstrip_scenes/knot.hpp"

namespace zstrip::effects_cost {

/// With all shades, so that programs differ in the effect alone.
inline constexpr Effects kK5 = without_shades(effects_of(scenes::knot.scene, scenes::knot.camera));

/// K5 with an effect, and the same without it.
struct Comparison {
  std::string_view effect;  ///< as in the source
  Effects added;
  Effects beside{};            ///< that both programs have beyond K5's: what the effect needs to show
  bool draws_the_same = true;  ///< whether both programs draw the same pixels

  constexpr Effects effects() const { return kK5 | beside | added; }
  constexpr Effects without_it() const { return without(kK5 | beside, added); }
};

/// All that a scene, a picture or a program can choose, and the methods that draw a scene as it is: method::bsp needs a
/// tree that was baked.
inline constexpr Comparison kComparisons[] = {
    {"lighting", effect::lighting},
    {"gouraud", effect::gouraud, {}, false},
    {"vertex_colours", effect::vertex_colours, {}, false},
    {"textures", effect::textures},
    {"orthographic", effect::orthographic, {}, false},
    {"statistics", effect::statistics},
    {"depth_state", effect::depth_state},
    {"depth_float", effect::depth_float},
    {"depth_24", effect::depth_24, {}, false},
    {"depth_ranges", effect::depth_ranges},
    {"bins", effect::bins},
    {"perspective_affine", effect::perspective_affine, effect::textures},
    {"perspective_8", effect::perspective_8, effect::textures},
    {"perspective_1", effect::perspective_1, effect::textures},
    {"fog", effect::fog},
    {"emissive", effect::emissive, effect::lighting},
    {"specular", effect::specular, effect::lighting},
    {"punctual_lights", effect::punctual_lights, effect::lighting},
    {"alpha_test", effect::alpha_test},
    {"blending", effect::blending},
    {"texture_alpha", effect::texture_alpha, effect::textures | effect::alpha_test},
    {"bilinear", effect::bilinear, effect::textures},
    {"texture_palettes", effect::texture_palettes, effect::textures},
    {"mipmaps", effect::mipmaps, effect::textures},
    {"environment", effect::environment, effect::textures},
    {"pixel_shading", effect::pixel_shading, effect::lighting},
    {"dithered_colours", effect::dithered_colours},
    {"dithered_format", effect::dithered_format},
    {"supersampled", effect::supersampled},
    {"quadrics", effect::quadrics},
    {"lines", effect::lines},
    {"billboards", effect::billboards},
    {"outlines", effect::outlines},
    {"shadows", effect::shadows, effect::lighting},
    {"csg", effect::csg},
    {"edges", effect::edges},
    {"overlay", effect::overlay},
    {"painter", method::painter},
    {"in_order", method::in_order, method::painter, false},
    {"front_to_back", method::front_to_back},
    {"hierarchical_z", method::hierarchical_z},
    {"midpoint", method::midpoint, {}, false},
    {"midpoint_safe", method::midpoint_safe},
    {"culling", method::culling},
};

/// K5 as far as renderers with these effects can draw it: without its colours, flat, or from a camera without
/// perspective.
template <Effects effects>
struct Drawable {
  static constexpr std::array<Mesh, 1> kMesh = [] {
    Mesh mesh = scenes::kKnotMesh[0];
    if (!effects.has(effect::vertex_colours)) mesh.colours = {};
    return std::array{mesh};
  }();
  static constexpr std::array<Material, 1> kMaterial = [] {
    Material material = scenes::kKnotMaterial[0];
    if (!effects.has(effect::gouraud)) material.smooth = Shading::flat;
    return std::array{material};
  }();
  static constexpr scenes::BuiltIn kBuiltIn = [] {
    scenes::BuiltIn scene = scenes::knot;
    scene.scene.meshes = kMesh;
    scene.scene.materials = kMaterial;
    if (effects.has(effect::orthographic)) scene.camera.projection = Projection::orthographic;
    return scene;
  }();
};

}  // namespace zstrip::effects_cost
