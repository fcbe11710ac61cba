// The catalogue: names, counts, and what firmware needs as constants.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "zstrip/effects.hpp"
#include "zstrip/scene/validate.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"
#include "zstrip_scenes/random.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/scenes.hpp"
#include "zstrip_scenes/spheres.hpp"
#include "zstrip_scenes/teapot.hpp"
#include "zstrip_scenes/teapot_meshlets.hpp"
#include "zstrip_scenes/terrain.hpp"
#include "zstrip_scenes/triangle.hpp"
#include "zstrip_scenes/wires.hpp"

namespace zstrip::scenes {
namespace {

// What a board with a single scene writes: all of it is known to the compiler.
static_assert(without_shades(effects_of(teapot.scene, teapot.camera)) == (effect::lighting | effect::gouraud));
static_assert(without_shades(effects_of(knot.scene, knot.camera)) == (effect::vertex_colours | effect::gouraud));
static_assert(without_shades(effects_of(knot_flat.scene, knot.camera)) == effect::vertex_colours);
static_assert(without_shades(effects_of(knot_textured.scene, knot.camera)) ==
              (effect::lighting | effect::textures | effect::gouraud));
static_assert(without_shades(effects_of(cube.scene, cube.camera)) == effect::textures);
static_assert(without_shades(effects_of(random50.scene, random50.camera)) == effect::vertex_colours);
static_assert(without_shades(effects_of(room.scene, room.camera)) == (effect::lighting | effect::textures));
static_assert(without_shades(effects_of(spheres.scene, spheres.camera)) ==
              (effect::quadrics | effect::lighting | effect::textures));
static_assert(without_shades(effects_of(wires.scene, wires.camera)) == (effect::lighting | effect::gouraud));
static_assert(without_shades(effects_of(terrain.scene, terrain.camera)) == (effect::vertex_colours | effect::gouraud));
constexpr Effects shades_of(const BuiltIn& built_in) {
  return effects_of(built_in.scene, built_in.camera) & effect::shades;
}
static_assert(shades_of(teapot) == effect::shade_gouraud);
static_assert(shades_of(knot_flat) == effect::shade_flat);
static_assert(shades_of(knot_textured) == effect::shade_textured_gouraud);
static_assert(shades_of(cube) == effect::shade_textured);
static_assert(shades_of(room) == (effect::shade_flat | effect::shade_textured_flat));
static_assert(shades_of(random50) == (effect::shade_flat | effect::two_sided));
static_assert(shades_of(spheres) == effect::shade_flat);
static_assert(plan(teapot_meshlets.counts, {.width = 128, .height = 64},
                   effects_of(teapot_meshlets.scene, teapot_meshlets.camera))
                  .status);
static_assert(count(knot.scene).triangles == 5120 && knot_meshlets.counts.largest_meshlet == 55);

TEST(Catalogue, EverySceneIsValid) {
  for (const BuiltIn& scene : built_in()) {
    const Status status = validate(scene.scene);
    EXPECT_TRUE(status) << scene.name << ": " << message(status.error) << " " << status.needed;
  }
}

TEST(Catalogue, CountsAreThoseOfTheScene) {
  for (const BuiltIn& scene : built_in()) {
    const SceneCounts counted = count(scene.scene);
    EXPECT_EQ(scene.counts.instances, counted.instances) << scene.name;
    EXPECT_EQ(scene.counts.triangles, counted.triangles) << scene.name;
    EXPECT_EQ(scene.counts.vertices, counted.vertices) << scene.name;
    EXPECT_EQ(scene.counts.largest_meshlet, counted.largest_meshlet) << scene.name;
    EXPECT_EQ(scene.counts.meshlets, counted.meshlets) << scene.name;
    EXPECT_EQ(scene.counts.longest_meshlet, counted.longest_meshlet) << scene.name;
    EXPECT_EQ(scene.counts.quadrics, counted.quadrics) << scene.name;
    EXPECT_EQ(scene.counts.colours_in_place, counted.colours_in_place) << scene.name;
  }
}

TEST(Catalogue, FindsEverySceneByItsOwnName) {
  std::set<std::string> names;
  for (const BuiltIn& scene : built_in()) {
    EXPECT_EQ(find(scene.name), &scene);
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name << " twice";
    EXPECT_EQ(std::string(scene.name).find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos);
    EXPECT_STRNE(scene.description, "");
  }
  EXPECT_EQ(names.size(), built_in().size());
}

TEST(Catalogue, FindsNothingElse) {
  using namespace std::string_view_literals;
  for (const std::string_view name :
       {""sv, "teapo"sv, "teapot "sv, "Teapot"sv, "teapot\0"sv, "\0"sv, "teapot_meshlets_"sv}) {
    EXPECT_EQ(find(name), nullptr) << name;
  }
}

}  // namespace
}  // namespace zstrip::scenes
