// Skins that are moved while they are drawn: the pixels of those that are moved before, and what a frame refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "../oracle/draw.hpp"
#include "creature.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_scenes/character.hpp"

namespace zstrip::test {
namespace {

/// A frame of the character as `effects` draw it with this budget.
template <Effects effects>
std::vector<std::uint16_t> character_at(const Scene& scene, const Camera& camera, const Budget& budget) {
  constexpr View kView{96, 128, PixelFormat::rgb565};
  const auto [status, plan] = zstrip::plan(scenes::character.counts, kView, effects, budget);
  EXPECT_TRUE(status);
  Renderer<effects> renderer;
  const picture::Picture drawn = picture::draw(renderer, scene, camera, kView, plan);
  EXPECT_TRUE(drawn.status) << message(drawn.status.error) << ' ' << drawn.status.needed;
  return rgb565_of(drawn);
}

/// Pixels of one triangle that a skin has behind so many without an area, in one meshlet.
std::ptrdiff_t pixels_behind(std::size_t others) {
  constexpr Effects kEffects = effect::lighting | effect::gouraud | effect::skins;
  constexpr View kView{32, 32, PixelFormat::rgb565};
  const Position positions[] = {{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}};
  const Normal normals[] = {{0, 0, 127, 0}, {0, 0, 127, 0}, {0, 0, 127, 0}};
  std::vector<Triangle> triangles(others, Triangle{0, 0, 0});
  triangles.push_back({0, 1, 2});
  Mesh mesh{};
  mesh.positions = positions, mesh.normals = normals, mesh.triangles = triangles;
  const VertexJoints joints[3] = {};
  Skin skin{};
  skin.mesh = &mesh, skin.vertices = joints;
  Position moved[3];
  Normal turned[3];
  Skinning skinning{};
  skinning.skin = &skin, skinning.positions = moved, skinning.normals = turned;
  Mesh drawn_mesh = mesh;
  drawn_mesh.skinning = &skinning;
  const Material material{.colour = {200, 200, 200, 255}};
  const Instance instance{};
  const DirectionalLight light{};
  Scene scene{};
  scene.meshes = {&drawn_mesh, 1}, scene.materials = {&material, 1}, scene.instances = {&instance, 1};
  scene.lights = {&light, 1};
  Camera camera{};
  camera.eye = {0, 0, fixed(4)};
  const auto [status, plan] = zstrip::plan(count(scene), kView, kEffects, {});
  EXPECT_TRUE(status);
  Renderer<kEffects> renderer;
  const picture::Picture drawn = picture::draw(renderer, scene, camera, kView, plan);
  EXPECT_TRUE(drawn.status) << message(drawn.status.error);
  const std::vector<std::uint16_t> pixels = rgb565_of(drawn);
  return std::ranges::count_if(pixels, [&](std::uint16_t pixel) { return pixel != pixels[0]; });
}

/// Lists of triangles have indices of 15 bits.
TEST(DrawnSkins, TrianglesFromIndex32768OnAreDrawn) {
  const std::ptrdiff_t alone = pixels_behind(0);
  EXPECT_GT(alone, 50);
  EXPECT_EQ(pixels_behind(32767), alone);
  EXPECT_EQ(pixels_behind(32768), alone);
}

/// One of the character's frames from afar, and from so near that much of it is clipped.
TEST(DrawnSkins, WhatIsMovedWhileItIsDrawnIsWhatIsMovedBefore) {
  using namespace scenes;
  constexpr Effects kSkins = effects_of(character.scene, character.camera);
  constexpr Effects kNone = without(kSkins, effect::skins);
  static_assert(kSkins != kNone);
  std::vector<Position> positions(kCharacterVertices);
  std::vector<Normal> normals(kCharacterVertices);
  std::vector<Meshlet> meshlets(kCharacterMeshletCount);
  std::vector<JointPose> joints(kCharacterRest.begin(), kCharacterRest.end());
  std::vector<Transform> work(kCharacterJoints);
  const MovedVertices moved{positions, normals, meshlets};
  const Mesh meshes[] = {moved_mesh(kCharacterBindMesh[0], moved)};
  Scene before = character.scene;
  before.meshes = meshes;
  Camera near = character.camera;
  near.eye = {fixed(0.1), fixed(0.3), fixed(0.55)};
  near.focal = fixed(0.8);
  const std::vector<std::uint16_t> at_rest = character_at<kSkins>(character.scene, character.camera, {});
  for (const std::uint32_t frame : {3U, 11U}) {
    ASSERT_TRUE(pose_character(frame));
    pose(kCharacterWalk, frame * kCharacterFrameTime, joints);
    ASSERT_TRUE(skin_mesh(kCharacterSkin, joints, work, moved));
    for (const Camera& camera : {character.camera, near}) {
      const std::vector<std::uint16_t> expected = character_at<kNone>(before, camera, {});
      EXPECT_NE(expected, at_rest);
      EXPECT_EQ(character_at<kSkins>(character.scene, camera, {}), expected);
      EXPECT_EQ(character_at<kSkins>(character.scene, camera, {.strip_rows = 17, .strip_columns = 40}), expected);
      EXPECT_EQ(
          character_at<kSkins | effect::bins>(character.scene, camera, {.strip_rows = 17, .modes = Modes::binned}),
          expected);
    }
  }
}

TEST(DrawnSkins, AFrameRefusesWhatCannotBeMovedWhileItIsDrawn) {
  Random random(8);
  Creature c = creature(random, 2);
  connect(c);
  Skinning skinning{.skin = &c.skin, .matrices = c.work, .positions = c.moved_positions, .normals = c.moved_normals};
  c.mesh.skinning = &skinning;
  const Instance instance;
  const Material material{.lit = true};
  const DirectionalLight light;
  Scene scene{.meshes = {&c.mesh, 1},
              .materials = {&material, 1},
              .textures = {},
              .instances = {&instance, 1},
              .lights = {&light, 1}};
  constexpr Effects kEffects =
      effect::lighting | effect::gouraud | effect::skins | effect::lines | effect::csg | effect::edges;
  constexpr View kView{32, 24, PixelFormat::rgb565};
  const auto error = [&] {
    const auto [status, plan] = zstrip::plan(count(scene), kView, effects_of(scene, {}));
    EXPECT_TRUE(status);
    Renderer<kEffects> renderer;
    return picture::draw(renderer, scene, {.eye = {0, 0, fixed(8)}}, kView, plan).status.error;
  };
  ASSERT_TRUE(pose_skin(skinning, c.rest));
  EXPECT_EQ(error(), Error::none);
  const Segment segment{0, 1};
  const LineSet lines{.segments = {&segment, 1}};
  scene.lines = {&lines, 1};
  EXPECT_EQ(error(), Error::skin);
  scene.lines = {};
  const Edge edge{0, 1, 2};
  const EdgeSet edges{{&edge, 1}, 0};
  scene.edges = {&edges, 1};
  EXPECT_EQ(error(), Error::skin);
  scene.edges = {};
  const CsgOperand operand{};
  scene.csg = {&operand, 1};
  EXPECT_EQ(error(), Error::skin);
  scene.csg = {};
  skinning.positions = std::span(c.moved_positions).first(29);  // a meshlet has 30
  EXPECT_EQ(error(), Error::skin);
  skinning.positions = std::span(c.moved_positions).first(30);
  EXPECT_EQ(error(), Error::none);
  skinning.normals = {};
  EXPECT_EQ(error(), Error::skin);
  skinning.normals = c.moved_normals;
  skinning.matrices = skinning.matrices.first(skinning.matrices.size() - 1);
  EXPECT_EQ(pose_skin(skinning, c.rest).error, Error::skin);
  EXPECT_EQ(error(), Error::skin);
}

/// What a vertex outside of the box does in a frame: nothing is known of it before.
TEST(DrawnSkins, WhatLeavesTheBoxWhileItIsDrawnStaysOnItsSide) {
  const Joint joints[1];
  const VertexJoints vertices[3];
  const JointPose rest[1];
  const Position positions[3] = {{-20000, -20000, 0}, {20000, -20000, 0}, {0, 20000, 0}};
  const Triangle triangles[1] = {{0, 1, 2}};
  Transform matrices[1];
  Position moved[3];
  const auto mesh_of = [&](const Position(&at)[3]) {
    return Mesh{.positions = at, .normals = {}, .colours = {}, .texcoords = {}, .triangles = triangles, .meshlets = {}};
  };
  const Mesh bind = mesh_of(positions);
  const Skin skin{&bind, vertices, joints, rest};
  Skinning skinning{.skin = &skin, .matrices = matrices, .positions = moved};
  JointPose pose[1];
  pose[0].translation.x = fixed(0.75);
  ASSERT_TRUE(pose_skin(skinning, pose));
  const Position outside[3] = {{4576, -20000, 0}, {32767, -20000, 0}, {24576, 20000, 0}};
  const Material material{.lit = false};
  const Instance instance;
  constexpr View kView{40, 32, PixelFormat::rgb565};
  const auto drawn = [&](Mesh mesh, Skinning* by) {
    mesh.skinning = by;
    const Scene scene{
        .meshes = {&mesh, 1}, .materials = {&material, 1}, .textures = {}, .instances = {&instance, 1}, .lights = {}};
    constexpr Effects kEffects = effect::skins;
    const auto [status, plan] = zstrip::plan(count(scene), kView, kEffects);
    EXPECT_TRUE(status);
    Renderer<kEffects> renderer;
    return rgb565_of(picture::draw(renderer, scene, {.eye = {0, 0, fixed(3)}}, kView, plan));
  };
  EXPECT_EQ(drawn(bind, &skinning), drawn(mesh_of(outside), nullptr));
  EXPECT_NE(drawn(bind, &skinning), drawn(bind, nullptr));
}

}  // namespace
}  // namespace zstrip::test
