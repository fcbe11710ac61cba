// Edges in a scene with a shadow: each pixel is what edges make of the picture with shadows, however it is divided.
#include <algorithm>
#include <vector>

#include "edges_of.hpp"
#include "shadow_world.hpp"

namespace effects_test {
namespace {

constexpr Effects kBoth = kShadowed | effect::edges | effect::bins;

/// World with the edges of its meshes.
struct EdgedWorld : World {
  std::vector<Edge> edges[3];
  EdgeSet sets[3];

  EdgedWorld() {
    for (std::uint16_t i = 0; i < 3; ++i) {
      const Mesh& mesh = meshes[i];
      edges[i] = edges_of_mesh(mesh, [&](std::size_t one, std::size_t other) {
        const Normal &a = mesh.normals[mesh.triangles[one].a], &b = mesh.normals[mesh.triangles[other].a];
        return i < 2 && (a.x != b.x || a.y != b.y || a.z != b.z);
      });
      sets[i] = {edges[i], i};
    }
    scene.edges = sets;
  }
};

Scene without_edges(Scene scene) {
  scene.edges = {};
  return scene;
}

/// Compares the picture of a world with pictures of edges or shadows alone.
template <Effects effects>
void expect_composed(EdgedWorld& world, const Budget& budget) {
  constexpr Effects kEdges = without(effects, effect::shadows), kPlain = without(kEdges, effect::edges);
  const Drawn both = draw<effects>(world.scene, world.camera, kView, budget);
  const Drawn shadowed = draw<kPlain | effect::shadows>(without_edges(world.scene), world.camera, kView, budget);
  const Scene lit = world.with_all_light(), dark = world.without_light();
  const Drawn plain_lit = draw<kPlain>(without_edges(lit), world.camera, kView, budget);
  const Drawn plain_dark = draw<kPlain>(without_edges(dark), world.camera, kView, budget);
  const Drawn edges_lit = draw<kEdges>(lit, world.camera, kView, budget);
  const Drawn edges_dark = draw<kEdges>(dark, world.camera, kView, budget);
  int blended[2] = {}, apart = 0;
  for (int y = 0; y < kView.height; ++y) {
    for (int x = 0; x < kView.width; ++x) {
      bool all_lit = true, all_dark = true;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, kView.height - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, kView.width - 1); ++i) {
          all_lit = all_lit && shadowed.at(i, j) == plain_lit.at(i, j);
          all_dark = all_dark && shadowed.at(i, j) == plain_dark.at(i, j);
        }
      }
      const bool is_edge = edges_lit.at(x, y) != plain_lit.at(x, y) || edges_dark.at(x, y) != plain_dark.at(x, y);
      if (all_lit) {
        EXPECT_EQ(both.at(x, y), edges_lit.at(x, y)) << x << ", " << y;
        blended[0] += is_edge ? 1 : 0;
      }
      if (all_dark) {
        EXPECT_EQ(both.at(x, y), edges_dark.at(x, y)) << x << ", " << y;
        blended[1] += is_edge && !all_lit ? 1 : 0;
      }
      if (!is_edge) {
        EXPECT_EQ(both.at(x, y), shadowed.at(x, y)) << x << ", " << y;
        apart += all_lit ? 0 : 1;
      }
    }
  }
  EXPECT_GT(blended[0], 100);
  EXPECT_GT(blended[1], 2);
  EXPECT_GT(apart, 100);
}

TEST(EdgesWithShadows, ArePicturesOfShadowsWhoseEdgesAreBlended) {
  for (int turn = 0; turn < 6; ++turn) {
    SCOPED_TRACE(turn);
    EdgedWorld world;
    const double angle = turn * 1.1;
    world.lights[0] = light_from(std::cos(angle) * (0.3 + 0.2 * turn), 1, std::sin(angle) * (0.3 + 0.2 * turn));
    expect_composed<kBoth>(world, {});
    expect_composed<kBoth>(world, {.strip_rows = 5, .modes = Modes::binned});
  }
}

/// A box that blends, in front of the ball's shadow: its fragments pass each time that they are drawn.
void make_glass(EdgedWorld& world, Finish& finish) {
  finish.alpha_mode = AlphaMode::blend;
  world.materials[1].colour.a = 120;
  world.materials[1].finish = 0;
  world.scene.finishes = {&finish, 1};
  world.scene.quadrics = {};
  world.instances[1].transform = placed(0.5, 0.5, 0.3, 1, 0.5);
  world.instances[2].material = 0;  // the ball casts a shadow
}

TEST(EdgesWithShadows, DoNotBlendTwice) {
  EdgedWorld world;
  Finish finish;
  make_glass(world, finish);
  constexpr Effects kGlass = without(kBoth, effect::quadrics) | effect::blending;
  expect_composed<kGlass>(world, {});
  expect_composed<kGlass>(world, {.strip_rows = 7, .strip_columns = 40});
}

TEST(EdgesWithShadows, KeepTheRulesOfMaterials) {
  constexpr Effects kRules = kBoth | effect::depth_state;
  for (const bool equal : {false, true}) {
    EdgedWorld world;
    if (equal) {
      world.materials[1].depth_test = DepthTest::nearer_or_equal;
    } else {
      world.materials[0].depth_write = false;
    }
    world.meshes[0].shadow = ShadowRole::only_receives;
    const Drawn whole = draw<kRules>(world.scene, world.camera, kView);
    EXPECT_EQ(draw<kRules>(world.scene, world.camera, kView, {.strip_rows = 3}), whole);
    if (equal) expect_composed<kRules>(world, {});
  }
}

template <Effects effects>
void expect_alike(const EdgedWorld& world) {
  const Drawn whole = draw<effects>(world.scene, world.camera, kView);
  EXPECT_NE(draw<effects>(without_edges(world.scene), world.camera, kView), whole);
  EXPECT_NE(draw<effects>(world.with_all_light(), world.camera, kView), whole);
  for (const int rows : {1, 2, 7, 48, 96}) {
    for (const int columns : {8, 40, 128}) {
      for (const Modes mode : {Modes::streamed, Modes::binned}) {
        const Budget budget{.strip_rows = static_cast<std::uint16_t>(rows),
                            .strip_columns = static_cast<std::uint16_t>(columns),
                            .modes = mode};
        EXPECT_EQ(draw<effects>(world.scene, world.camera, kView, budget), whole)
            << rows << " rows, " << columns << " columns, " << (mode == Modes::binned ? "binned" : "streamed");
      }
    }
  }
  EXPECT_EQ(
      draw_any(effects | effect::blending | effect::depth_state, world.scene, world.camera, kView, {.strip_rows = 10}),
      whole);
}

TEST(EdgesWithShadows, NeitherStripsNorBinsChangeAPixel) {
  EdgedWorld world;
  expect_alike<kBoth>(world);
  Finish finish;
  make_glass(world, finish);
  expect_alike<without(kBoth, effect::quadrics) | effect::blending>(world);
}

/// A plan has room for the codes that the strip's pixels do not hold, and no more.
TEST(EdgesWithShadows, TakeTheBytesThatThePlanSays) {
  EdgedWorld world;
  world.shadow.pool = 40001;
  Finish finish;
  for (const bool glass : {false, true}) {
    if (glass) make_glass(world, finish);
    const Effects effects = without_shades(effects_of(world.scene, world.camera));
    for (const PixelFormat format : {PixelFormat::rgb565, PixelFormat::gray4}) {
      const View view{kView.width, kView.height, format};
      const Plan right = plan(count(world.scene), view, effects, {.strip_rows = 8}).plan;
      const std::uint32_t pixels = 128 * 8, drawn = 128 * 10;
      const std::uint32_t resolved = format == PixelFormat::rgb565 ? 0 : pixels;
      EXPECT_EQ(right.colour_bytes, 2 * (drawn + resolved + (glass ? drawn - pixels : 0)));
      const std::uint32_t groups = count(world.scene).edge_groups;
      EXPECT_GE(right.effect_bytes, 16 + 2656 + 40001 + 8 + 5 * groups + (glass ? 3 * 16 : 0));
      EXPECT_LE(right.effect_bytes, 16 + 2656 + 40001 + 8 + 5 * groups + (glass ? 3 * 16 : 0) + 14);
      Plan less = right;
      less.colour_bytes -= kArenaAlignment;
      EXPECT_EQ(begun(AnyRenderer(effects), world.scene, world.camera, view, less).purpose, Purpose::colour);
      const Status status = begun(AnyRenderer(effects), world.scene, world.camera, view, right);
      EXPECT_TRUE(status) << message(status.error) << " " << status.needed;
    }
  }
}

}  // namespace
}  // namespace effects_test
