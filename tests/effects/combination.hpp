// Sets of effects, and a scene that calls for exactly such a set: two boxes, one behind the other, perhaps turned to
// the viewer, a sphere and lines, a third box with an outline, and a fourth less a fifth; or edges of the first two;
// sprites and labels over all of it. As a skin each of the first two is smaller and turned.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "drawn.hpp"
#include "edges_of.hpp"
#include "overlay_scene.hpp"
#include "zstrip/effects/exclusions.hpp"
#include "zstrip_scenes/effect_scenes.hpp"

namespace effects_test {

/// Everything that a set may have or not: all effects but those that exclude many others, or are of a plan.
inline constexpr auto kFactors = [] {
  constexpr Effects kLeftOut = effect::csg | effect::edges | effect::dithered_format | effect::bins | effect::unclipped;
  constexpr auto kIsFactor = [](const EffectName& each) { return !each.effect.any(kLeftOut); };
  std::array<Effects, std::ranges::count_if(kEffectNames, kIsFactor)> factors{};
  std::size_t count = 0;
  for (const EffectName& each : kEffectNames) {
    if (kIsFactor(each)) factors[count++] = each.effect;
  }
  return factors;
}();

/// With what its effects need to show.
constexpr Effects completed(Effects set) {
  if (set.has(effect::texture_alpha) && !set.any(effect::alpha_test | effect::blending)) set = set | effect::alpha_test;
  if (set.any(effect::texture_alpha | effect::bilinear | effect::texture_palettes | effect::mipmaps |
              effect::environment)) {
    set = set | effect::textures;
  }
  const bool unlit_texels = set.has(effect::textures | effect::vertex_colours);  // have no vertex colours
  if (set.any(effect::vertex_light | effect::gouraud | effect::shadows | effect::pixel_shading) || unlit_texels) {
    set = set | effect::lighting;
  }
  return set;
}

inline constexpr std::size_t kRows = 8;

/// A row of a covering array: of every two factors it has both, either and neither somewhere. Kleitman and Spencer:
/// columns are different words of 8 bits that have 4 ones, none of them in the first row.
constexpr Effects row(std::size_t index) {
  Effects set{};
  unsigned word = 0;
  for (const Effects factor : kFactors) {
    do ++word;
    while (__builtin_popcount(word) != 4);
    if (index != 0 && (word >> (index - 1) & 1U) != 0) set = set | factor;
  }
  return set;
}

constexpr bool covers_all_pairs() {
  for (const Effects a : kFactors) {
    for (const Effects b : kFactors) {
      if (a == b) continue;
      bool seen[4] = {};
      for (std::size_t i = 0; i < kRows; ++i) seen[(row(i).has(a) ? 2 : 0) + (row(i).has(b) ? 1 : 0)] = true;
      if (!seen[0] || !seen[1] || !seen[2] || !seen[3]) return false;
    }
  }
  return true;
}
static_assert(covers_all_pairs());

constexpr auto kBoxColours = [] {
  std::array<Colour, 24> colours{};
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const auto level = static_cast<std::uint8_t>(80 + 7 * i);
    colours[i] = {level, 200, static_cast<std::uint8_t>(255 - level), 255};
  }
  return colours;
}();

/// Enough for any format of 16x16 texels with all smaller levels.
constexpr auto kNoise = [] {
  std::array<std::uint16_t, 512> words{};
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint16_t>(i * 40503 + 0x7080);
  return words;
}();

/// With a picture that is dithered or has samples if that is in the set, calls for exactly completed(set).
struct Combination {
  Mesh meshes[4] = {scenes::kRoomMeshes[0], scenes::kRoomMeshes[1], scenes::kRoomMeshes[0], scenes::kRoomMeshes[1]};
  Shadow shadow{.log2_size = 5};
  DirectionalLight over_the_near_box[1] = {{14100, 8500, 28200, {220, 210, 190, 255}}};  // on the far one
  Outline outlines[1] = {{.colour = {200, 0, 120, 255}, .width = 30}};
  Finish finishes[3];
  Material materials[4];
  Texture textures[2] = {{scenes::kLatticeTexels, 4, 4}, {scenes::kIndexedTexels, 4, 4, TextureFormat::palette4}};
  Instance instances[5] = {
      scenes::block(0, 0.5, 0.5, 0.5, -0.2, 0, -0.6), scenes::block(1, 0.5, 0.5, 0.5, 0.2, 0.1, 0.5),
      scenes::block(2, 0.3, 0.3, 0.3, -0.4, 0.5, 0.7), scenes::block(3, 0.45, 0.45, 0.45, 0.5, -0.5, 0.6),
      scenes::block(3, 0.3, 0.3, 0.3, 0.3, -0.3, 1.0)};
  CsgOperand operands[2] = {{3, 0, CsgUse::intersected}, {4, 0, CsgUse::subtracted}};
  Quadric quadrics[1] = {
      {.material = 2,
       .transform = {
           {{fixed(0.4), 0, 0, fixed(-0.3)}, {0, fixed(0.4), 0, fixed(0.5)}, {0, 0, fixed(0.4), fixed(0.4)}}}}};
  Segment segments[4] = {{0, 3}, {4, 9}, {12, 21}, {2, 2}};
  std::vector<Edge> edges[2];
  EdgeSet edge_sets[2];
  LineSet lines[1] = {{.segments = segments, .mesh = 0, .material = 2, .width = 3}};
  static constexpr std::size_t kCorners = 24;
  VertexJoints corner_joints[kCorners];
  Joint joints[1];
  JointPose pose[1] = {{.rotation = {2500, 3500, 0, 32480}, .scale = {fixed(0.72), fixed(0.72), fixed(0.72)}}};
  Transform matrices[1];
  Position moved_positions[kCorners];
  Normal moved_normals[kCorners];
  Mesh bind = scenes::kRoomMeshes[1];
  Skin skin{&bind, corner_joints, joints, pose};
  Skinning skinning{.skin = &skin, .matrices = matrices, .positions = moved_positions, .normals = moved_normals};
  Camera camera = scenes::turntable_camera(4.0, 20, 2.2);
  Scene scene;

  explicit Combination(Effects set) {
    const int indexed = set.has(effect::alpha_test) ? 1 : 0;  // the other one's texture may have alpha
    for (int i = 0; i < 3; ++i) {
      Finish& finish = finishes[i];
      if (set.has(effect::emissive)) finish.emissive = {40, 20, 0, 255};
      if (set.has(effect::specular)) finish.specular = {200, 200, 200, 255};
      if (set.has(effect::bilinear)) finish.filter = TextureFilter::bilinear;
      Material& material = materials[i < 2 ? i : 3];
      material = {.colour = {200, 180, 160, 150}, .lit = set.has(effect::lighting), .smooth = set.has(effect::gouraud)};
      material.finish = static_cast<std::uint8_t>(i);
      if (set.has(effect::textures)) material.texture = set.has(effect::texture_palettes) && i == indexed ? 1 : 0;
      if (set.has(effect::depth_state) && i < 2) material.depth_test = DepthTest::nearer_or_equal;
    }
    if (set.has(effect::pixel_shading)) materials[1].smooth = Shading::pixel;
    if (set.has(effect::alpha_test)) finishes[0].alpha_mode = AlphaMode::mask;
    if (set.has(effect::blending)) finishes[1].alpha_mode = AlphaMode::blend;
    if (set.has(effect::environment)) finishes[1].filter = of_environment(finishes[1].filter);
    if (set.has(effect::texture_alpha)) textures[0].format = TextureFormat::rgb565_alpha;
    if (set.has(effect::mipmaps)) {
      for (Texture& texture : textures) texture.texels = kNoise, texture.smaller_levels = 4;
    }
    if (set.has(effect::orthographic)) {
      camera.projection = Projection::orthographic;
      camera.focal = fixed(0.7);
    }
    materials[2] = {.colour = {240, 220, 40, 255}, .lit = false};
    if (set.has(effect::vertex_colours)) meshes[1].colours = kBoxColours;
    if (set.has(effect::skins)) {
      EXPECT_TRUE(validate(skin) && pose_skin(skinning, pose));
      meshes[1].skinning = &skinning;
    }
    if (set.has(effect::billboards)) meshes[0].billboard = Billboard::upright, meshes[1].billboard = Billboard::viewer;
    if (set.has(effect::quadrics)) scene.quadrics = quadrics;
    if (set.has(effect::lines)) scene.lines = lines;
    scene.meshes = meshes;
    scene.materials = materials;
    scene.textures = textures;
    // Its material is the sphere's and the lines', opaque and without anything.
    if (set.has(effect::outlines)) meshes[2].outline = 1;
    instances[2].mesh = instances[2].material = 2;
    scene.instances = std::span(instances).first(set.has(effect::csg) ? 5 : set.has(effect::outlines) ? 3 : 2);
    // What is solid has everything that the near box has, but is opaque, and stays where it is.
    instances[3].mesh = instances[4].mesh = 3;
    if (set.has(effect::csg)) scene.csg = operands;
    if (set.has(effect::outlines)) scene.outlines = outlines;
    if (set.has(effect::edges)) {
      for (std::uint16_t i = 0; i < 2; ++i) {
        edges[i] = edges_of_mesh(meshes[i], [](std::size_t first, std::size_t second) { return second - first > 1; });
        edge_sets[i] = {edges[i], i};
      }
      scene.edges = edge_sets;
    }
    if (set.has(effect::overlay)) scene.overlay = &scenes::kKnotOverlay;
    scene.finishes = finishes;
    scene.background = {30, 60, 90, 255};
    if (set.has(effect::lighting)) scene.lights = scenes::kKeyLight;
    if (set.has(effect::shadows)) scene.shadow = &shadow, scene.lights = over_the_near_box;
    if (set.has(effect::punctual_lights)) scene.punctual_lights = scenes::kPunctualLights;
    if (set.has(effect::fog)) scene.fog = &scenes::kFog;
  }

  /// Draws no skin any more, but what skin_mesh makes of it.
  void move_before() {
    const MovedVertices moved{moved_positions, moved_normals, {}};
    EXPECT_TRUE(skin_mesh(skin, pose, matrices, moved));
    meshes[1] = moved_mesh(meshes[1], moved);
    meshes[1].skinning = nullptr;
  }
};

/// A picture that calls for those of `set` that pictures call for.
constexpr View view_of(Effects set) {
  return {40, 32, set.has(effect::dithered_format) ? PixelFormat::mono : PixelFormat::rgb565,
          set.any(effect::dithered_colours | effect::dithered_format),
          set.has(effect::supersampled) ? kMaxSamples : std::uint8_t{1}};
}

/// With a word less in any part of a plan the frame is refused, for the purpose of that part.
template <class AnyKind>
void expect_nothing_to_spare(AnyKind&& renderer, const Combination& drawn, const View& view, const Plan& whole) {
  EXPECT_TRUE(begun(renderer, drawn.scene, drawn.camera, view, whole));
  for (const auto& [part, purpose] : {std::pair{&Plan::instance_bytes, Purpose::instances},
                                      {&Plan::extent_bytes, Purpose::extents},
                                      {&Plan::vertex_bytes, Purpose::vertices},
                                      {&Plan::depth_bytes, Purpose::depth},
                                      {&Plan::colour_bytes, Purpose::colour},
                                      {&Plan::effect_bytes, Purpose::effects}}) {
    if (whole.*part == 0) continue;
    Plan less = whole;
    less.*part -= kArenaAlignment;
    const Status status = begun(renderer, drawn.scene, drawn.camera, view, less);
    EXPECT_EQ(status.error, Error::arena_too_small) << name(purpose);
    EXPECT_EQ(status.purpose, purpose);
    EXPECT_GT(status.needed, less.*part) << name(purpose);
    EXPECT_LE(status.needed, whole.*part) << name(purpose);
  }
}

/// Draws completed(set) by its own pipeline, whole and in strips, and by the host's.
template <Effects set>
void expect_drawn_alike() {
  constexpr Effects kSet = completed(set);
  constexpr View kView = view_of(set);
  SCOPED_TRACE(testing::Message() << std::hex << kSet.bits);
  Combination combination(kSet);
  const Scene& scene = combination.scene;
  const Camera& camera = combination.camera;
  ASSERT_EQ(without_shades(effects_of(scene, camera)) | effects_of(kView), kSet);
  const Drawn whole = draw<kSet>(scene, camera, kView);
  const auto background = static_cast<std::uint16_t>(30 >> 3 << 11 | 60 >> 2 << 5 | 90 >> 3);
  EXPECT_GT(std::ranges::count_if(whole.pixels, [&](std::uint16_t pixel) { return pixel != background; }),
            kSet.has(effect::skins) ? 80 : 100);
  EXPECT_EQ(draw<kSet>(scene, camera, kView, {.strip_rows = 5, .strip_columns = 16}), whole);
  EXPECT_EQ(draw_any(kSet, scene, camera, kView, {.strip_rows = 9}), whole);
  EXPECT_EQ(draw_any(kSet | effect::bins, scene, camera, kView, {.strip_rows = 9, .modes = Modes::binned}), whole);
  if constexpr (kSet.has(effect::skins)) {
    Combination before(kSet);
    before.move_before();
    EXPECT_EQ(draw_any(without(kSet, effect::skins), before.scene, camera, kView, {.strip_rows = 9}), whole);
  }
  // Memory is planned for what is there, and not for more.
  for (const PixelFormat format : {kView.format, PixelFormat::mono}) {
    const View view{kView.width, kView.height, format, kView.dither && format == kView.format, kView.samples};
    expect_nothing_to_spare(Renderer<kSet>(), combination, view,
                            zstrip::plan(count(scene), view, kSet, {.strip_rows = 9}).plan);
  }
  expect_nothing_to_spare(
      AnyRenderer(kSet | effect::bins), combination, kView,
      zstrip::plan(count(scene), kView, kSet | effect::bins, {.strip_rows = 9, .modes = Modes::binned}).plan);
  const Plan plan = zstrip::plan(count(scene), kView, kSet).plan;
  EXPECT_EQ(plan.effect_bytes != 0,
            kSet.any(effect::fog | effect::blending | effect::local_light | effect::billboards | effect::environment |
                     effect::outlines | effect::shadows | effect::csg | effect::edges));
  EXPECT_EQ(plan.colour_bytes, 40U * 32 * 2 * (kSet.has(effect::supersampled) ? 4 : kSet.has(effect::edges) ? 1 : 0));
  EXPECT_EQ(plan.bin_bytes + plan.visibility_bytes, 0U);
}

}  // namespace effects_test
