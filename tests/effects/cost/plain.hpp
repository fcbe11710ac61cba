// The scenes of effects without their effects.
#pragma once

#include <array>
#include <cstddef>

#include "../billboards_scene.hpp"
#include "../csg_scene.hpp"
#include "../edges_scene.hpp"
#include "../lines_scene.hpp"
#include "../outlines_scene.hpp"
#include "../overlay_scene.hpp"
#include "../shadows_scene.hpp"
#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/spheres.hpp"

namespace zstrip::scenes {

constexpr BuiltIn named(BuiltIn scene, const char* name) {
  scene.name = name;
  return scene;
}

/// Of the knot, light and what is smooth; of the cube, texels, and ways to place them.
inline constexpr Mesh kLitKnotMesh[] = {[] {
  Mesh mesh = kKnotMesh[0];
  mesh.normals = kKnotNormals;
  return mesh;
}()};
inline constexpr Material kLitKnotMaterial[] = {{.lit = true, .smooth = true}};
inline constexpr BuiltIn lit = [] {
  BuiltIn scene = knot_lit;
  scene.name = "lit";
  scene.scene.meshes = kLitKnotMesh;
  scene.scene.materials = kLitKnotMaterial;
  return scene;
}();
inline constexpr BuiltIn smooth = named(knot, "smooth");
inline constexpr BuiltIn textured = named(cube, "textured");
inline constexpr BuiltIn affine = named(cube, "affine");
inline constexpr BuiltIn every_8 = named(cube, "every_8");
inline constexpr BuiltIn every_pixel = named(cube, "every_pixel");

/// The knot in pictures that call for an effect.
inline constexpr BuiltIn dithered = named(knot, "dithered");
inline constexpr BuiltIn dithered_mono = named(knot, "dithered_mono");
inline constexpr BuiltIn samples_2 = named(knot, "samples_2");
inline constexpr BuiltIn samples_4 = named(knot, "samples_4");

}  // namespace zstrip::scenes

namespace zstrip::effects_cost {

inline constexpr std::uint16_t kWidth = 160, kHeight = 120;
/// The picture of a scene as it is, or plain.
template <const scenes::BuiltIn& built_in, bool plain>
inline constexpr View kView{kWidth, kHeight, PixelFormat::rgb565};
template <bool plain>
inline constexpr View kView<scenes::dithered, plain>{kWidth, kHeight, PixelFormat::rgb565, !plain};
template <bool plain>
inline constexpr View kView<scenes::dithered_mono, plain>{kWidth, kHeight, PixelFormat::mono, !plain};
template <bool plain>
inline constexpr View kView<scenes::samples_2, plain>{kWidth, kHeight, PixelFormat::rgb565, false, plain ? 1 : 2};
template <bool plain>
inline constexpr View kView<scenes::samples_4, plain>{kWidth, kHeight, PixelFormat::rgb565, false, plain ? 1 : 4};
inline constexpr std::uint32_t kFrames = 4, kFramesPerTurn = 36;

/// What a knot gets in place of an environment map: about as many texels as it mirrors of it.
inline constexpr auto kKnotTexcoords = [] {
  std::array<TexCoord, scenes::kKnotVertices> texcoords{};
  for (std::size_t i = 0; i < texcoords.size(); ++i) {
    texcoords[i] = {static_cast<std::int16_t>(i % 16 * 256), static_cast<std::int16_t>(i / 16 * 64)};
  }
  return texcoords;
}();

/// Whether it is the same light at vertices that light at pixels is compared with.
template <const scenes::BuiltIn& built_in>
inline constexpr bool kKeepsLight = effects_of(built_in.scene, built_in.camera).has(effect::pixel_shading);

/// Of scenes that lose no other effect: what materials call for, and what programs choose.
template <const scenes::BuiltIn& built_in>
inline constexpr Effects kBasic{};
template <>
inline constexpr Effects kBasic<scenes::lit> = effect::lighting;
template <>
inline constexpr Effects kBasic<scenes::smooth> = effect::gouraud;
template <>
inline constexpr Effects kBasic<scenes::textured> = effect::textures;
template <const scenes::BuiltIn& built_in>
inline constexpr Effects kChoice{};
template <>
inline constexpr Effects kChoice<scenes::affine> = effect::perspective_affine;
template <>
inline constexpr Effects kChoice<scenes::every_8> = effect::perspective_8;
template <>
inline constexpr Effects kChoice<scenes::every_pixel> = effect::perspective_1;

/// Without fog, finishes, punctual lights, quadrics, lines, outlines, shadows, products, edges and overlay, billboards
/// and skins standing still, the scene's first texture for one with a palette, and texture coordinates for environment
/// maps; lit at vertices, with its finishes, what was lit at pixels; of kBasic what it says; all else as
/// it is.
template <const scenes::BuiltIn& built_in>
struct Plain {
  static constexpr auto kMaterials = [] {
    std::array<Material, built_in.scene.materials.size()> materials{};
    for (std::size_t i = 0; i < materials.size(); ++i) {
      materials[i] = built_in.scene.materials[i];
      if (!kKeepsLight<built_in>) materials[i].finish = kNoFinish;
      if (materials[i].smooth == Shading::pixel) materials[i].smooth = Shading::gouraud;
      if (kBasic<built_in>.has(effect::lighting) && materials[i].lit) materials[i].lit = false;
      if (kBasic<built_in>.has(effect::gouraud)) materials[i].smooth = Shading::flat;
      std::uint16_t& texture = materials[i].texture;
      if (kBasic<built_in>.has(effect::textures)) texture = kNoTexture;
      if (texture != kNoTexture && has_palette(built_in.scene.textures[texture].format)) texture = 0;
    }
    return materials;
  }();
  static constexpr auto kMeshes = [] {
    std::array<Mesh, built_in.scene.meshes.size()> meshes{};
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      meshes[i] = built_in.scene.meshes[i];
      meshes[i].billboard = Billboard::none;
      if (effects_of(built_in.scene, built_in.camera).has(effect::environment)) meshes[i].texcoords = kKnotTexcoords;
      meshes[i].outline = 0;
      meshes[i].skinning = nullptr;
    }
    return meshes;
  }();
  static constexpr scenes::BuiltIn kBuiltIn = [] {
    scenes::BuiltIn plain = built_in;
    plain.scene.meshes = kMeshes;
    plain.scene.materials = kMaterials;
    plain.scene.fog = nullptr;
    if (!kKeepsLight<built_in>) plain.scene.finishes = {};
    plain.scene.punctual_lights = {};
    plain.scene.quadrics = {};
    plain.counts.quadrics = 0;
    plain.scene.lines = {};
    plain.counts.line_sets = 0;
    plain.scene.outlines = {};
    plain.scene.shadow = nullptr;
    plain.scene.csg = {};
    plain.scene.edges = {};
    plain.scene.overlay = nullptr;
    plain.pose = nullptr;
    plain.pose_bytes = 0;
    if constexpr (!built_in.scene.outlines.empty() || built_in.scene.shadow != nullptr || !built_in.scene.csg.empty() ||
                  !built_in.scene.edges.empty())
      plain.counts = count(plain.scene);
    return plain;
  }();
};

/// As it is, or plain.
template <const scenes::BuiltIn& built_in, bool plain>
inline constexpr const scenes::BuiltIn& kChosen = built_in;
template <const scenes::BuiltIn& built_in>
inline constexpr const scenes::BuiltIn& kChosen<built_in, true> = Plain<built_in>::kBuiltIn;

inline constexpr Effects kPlainLacks = effect::fragments | effect::vertex_light | effect::surfaces |
                                       effect::billboards | effect::environment | effect::outlines | effect::shadows |
                                       effect::csg | effect::edges | effect::overlay | effect::skins;
/// What the plain one has not.
template <const scenes::BuiltIn& built_in>
inline constexpr Effects kTaken = kKeepsLight<built_in> ? effect::fragments
                                  : (kBasic<built_in> | kChoice<built_in>).bits != 0
                                      ? kBasic<built_in> | kChoice<built_in>
                                      : kPlainLacks;
/// The pipeline of kChosen. The plain one keeps what the effect brought along, as quadrics their textures. Both have
/// all shades, so that they differ in the effect alone.
template <const scenes::BuiltIn& built_in, bool plain>
inline constexpr Effects kEffectsOf = without(without_shades(effects_of(built_in.scene, built_in.camera)) |
                                                  kChoice<built_in> | effects_of(kView<built_in, plain>),
                                              plain ? kTaken<built_in> : Effects{});

}  // namespace zstrip::effects_cost
