// pick: names what each pixel of a picture shows, with every effect and division into strips, compared with pictures of
// scenes whose surfaces have one colour each, and with rays in real numbers.
#include "zstrip/pick.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "../oracle/rays.hpp"
#include "begun_frame.hpp"
#include "combination.hpp"
#include "id_scene.hpp"
#include "lines_scene.hpp"
#include "zstrip/area.hpp"
#include "zstrip/fixed_renderer.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip {

void PrintTo(const Picked& picked, std::ostream* out) {
  *out << "kind " << static_cast<int>(picked.shown) << ", index " << picked.index << ", triangle " << picked.triangle
       << ", " << (picked.textured ? "at " : "no ") << picked.u << ", " << picked.v;
}

}  // namespace zstrip

namespace effects_test {
namespace {

Picked without_place(Picked picked) {
  picked.textured = false;
  picked.u = picked.v = 0;
  return picked;
}

/// Compares pick with the picture of `ids` at every pixel; returns the number of pixels that show something.
int expect_ids(const IdScene& ids, const Scene& scene, const Camera& camera, const View& view, Effects effects,
               const Budget& budget) {
  const View plain{view.width, view.height};
  const Effects drawing = effects_of(ids.scene(), camera) | (effects & effect::perspective_runs);
  const Drawn truth = draw_any(drawing, ids.scene(), camera, plain);
  const BegunFrame frame(scene, camera, view, effects, budget);
  int shown = 0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const Picked wanted = ids.shown_by(truth.at(x, y));
      shown += wanted.shown != Shown::background ? 1 : 0;
      EXPECT_EQ(without_place(frame.picked(x, y)), wanted) << "pixel " << x << ", " << y;
      if (testing::Test::HasFailure()) return shown;
    }
  }
  return shown;
}

TEST(EffectsPick, APixelNamesTheTriangleWhoseColourItHasWithEveryEffect) {
  int shown = 0;
  for (std::size_t i = 0; i < kRows; ++i) {
    // Overlays and samples have tests of their own.
    constexpr Effects kApart = effect::overlay | effect::supersampled;
    const Effects set = completed(without(row(i), kApart));
    const Effects with_edges = completed(without(row(i), kApart | effect::outlines | effect::skins));
    for (const Effects each : {set, with_edges | effect::edges}) {
      SCOPED_TRACE(testing::Message() << std::hex << each.bits);
      const Combination drawn(each);
      Combination still(each);
      if (each.has(effect::skins)) still.move_before();
      const IdScene ids(still.scene, still.camera);
      for (const Budget& budget : {kStreamed, kTiles, kBinned, kWhole}) {
        shown += expect_ids(ids, drawn.scene, drawn.camera, view_of(each), each, budget);
        ASSERT_FALSE(HasFailure());
      }
    }
  }
  EXPECT_GT(shown, 10000);
}

/// Scenes that IdScene takes: built-in ones, and those of effects.
std::vector<const scenes::BuiltIn*> scenes_with_ids() {
  std::vector<const scenes::BuiltIn*> found{&scenes::fog,     &scenes::mask,    &scenes::blend, &scenes::bilinear,
                                            &scenes::palette, &scenes::mipmaps, &scenes::lines, &scenes::environment};
  for (const scenes::BuiltIn& built_in : scenes::built_in()) {
    const Scene& scene = built_in.scene;
    if (count(scene).triangles > 15000 || !scene.csg.empty() || !scene.edges.empty() || scene.overlay != nullptr)
      continue;
    if (effects_of(scene, built_in.camera).has(effect::skins)) continue;
    found.push_back(&built_in);
  }
  return found;
}

/// The camera nearer to the origin, so that near surfaces are clipped.
Camera closer(Camera camera, int percent) {
  const auto share = [percent](Fixed value) { return static_cast<Fixed>(std::int64_t{value} * percent / 100); };
  camera.eye = {share(camera.eye.x), share(camera.eye.y), share(camera.eye.z)};
  return camera;
}

TEST(EffectsPick, RandomPixelsOfBuiltInScenesNameTheirTrianglesAlsoWhereTheseAreClipped) {
  std::mt19937 random(51);
  constexpr View kView{160, 120};
  int scenes = 0, kinds[7] = {};
  for (const scenes::BuiltIn* const built_in : scenes_with_ids()) {
    SCOPED_TRACE(built_in->name);
    ++scenes;
    for (const int percent : {100, 40}) {
      const Camera camera = closer(built_in->camera, percent);
      const IdScene ids(built_in->scene, camera);
      const Effects effects = effects_of(built_in->scene, camera);
      const Drawn truth = draw_any(effects_of(ids.scene(), camera), ids.scene(), camera, kView);
      for (const Budget& budget : {kStreamed, kBinned}) {
        const BegunFrame frame(built_in->scene, camera, kView, effects, budget);
        for (int i = 0; i < 300; ++i) {
          const int x = static_cast<int>(random() % kView.width), y = static_cast<int>(random() % kView.height);
          const Picked wanted = ids.shown_by(truth.at(x, y));
          ++kinds[static_cast<int>(wanted.shown)];
          ASSERT_EQ(without_place(frame.picked(x, y)), wanted) << "pixel " << x << ", " << y << ", " << percent << " %";
        }
      }
    }
  }
  EXPECT_GE(scenes, 15);
  EXPECT_GT(kinds[static_cast<int>(Shown::instance)], 5000);
  for (const Shown shown : {Shown::background, Shown::quadric, Shown::line}) {
    EXPECT_GT(kinds[static_cast<int>(shown)], 0) << static_cast<int>(shown);
  }
}

/// A ray through a pixel's centre, moved by some sixteenths of a pixel.
oracle::Ray ray_near(const Camera& camera, const View& view, int x, int y, int right, int down) {
  return oracle::ray_through(camera, view, x + 0.5 + right / 16.0, y + 0.5 + down / 16.0);
}

TEST(EffectsPick, ThePickedTriangleIsTheFirstThatARayMeets) {
  std::mt19937 random(1);
  constexpr View kView{96, 72};
  int met = 0;
  for (const char* const name : {"knot", "room", "teapot"}) {
    SCOPED_TRACE(name);
    const scenes::BuiltIn& built_in = *scenes::find(name);
    const Scene& scene = built_in.scene;
    const Camera& camera = built_in.camera;
    const BegunFrame frame(scene, camera, kView, effects_of(scene, camera), kStreamed);
    for (int i = 0; i < 60; ++i) {
      const int x = static_cast<int>(random() % kView.width), y = static_cast<int>(random() % kView.height);
      SCOPED_TRACE(testing::Message() << "pixel " << x << ", " << y);
      // Vertices are snapped to sixteenths: rays around the centre say what it may be, those that agree what it is.
      double first[9];
      const Picked picked = frame.picked(x, y);
      bool meets = false;
      double distance = 0;
      for (int r = 0; r < 9; ++r) {
        const oracle::Ray ray = ray_near(camera, kView, x, y, r % 3 - 1, r / 3 - 1);
        first[r] = 1e9;
        for (std::size_t n = 0; n < scene.instances.size(); ++n) {
          const Instance& instance = scene.instances[n];
          const Mesh& mesh = scene.meshes[instance.mesh];
          for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const oracle::Facet facet = oracle::facet_of(mesh, instance.transform, mesh.triangles[t]);
            if (!scene.materials[instance.material].double_sided && oracle::dot(facet.normal(), ray.along) > 0)
              continue;
            const std::optional<double> at = oracle::meets(facet, ray);
            if (!at || *at < std::ldexp(camera.near_plane, -16)) continue;
            first[r] = std::min(first[r], *at);
            if (picked.shown == Shown::instance && n == picked.index && t == picked.triangle)
              meets = true, distance = *at;
          }
        }
      }
      if (picked.shown == Shown::background) {
        EXPECT_EQ(*std::ranges::max_element(first), 1e9);
        continue;
      }
      ASSERT_EQ(picked.shown, Shown::instance);
      EXPECT_TRUE(meets);
      ++met;
      // Nearer surfaces at all rays would hide it.
      EXPECT_LE(distance, *std::ranges::max_element(first) + 1e-2 * distance);
    }
  }
  EXPECT_GT(met, 60);
}

/// Draws unlit texels whose colours are their numbers, and compares them with the places that pick returns.
template <Effects effects>
int expect_texels(const Combination& of, const View& view, const Budget& budget) {
  const Scene& scene = of.scene;
  std::vector<std::vector<std::uint16_t>> words;
  std::vector<Texture> textures(scene.textures.begin(), scene.textures.end());
  for (Texture& texture : textures) {
    if (has_palette(texture.format)) continue;
    words.emplace_back(texture.texels.begin(), texture.texels.end());
    texture.smaller_levels = 0;
    for (std::uint16_t i = 0; i < 256; ++i) words.back()[i] = static_cast<std::uint16_t>(2 * i + 1);
    texture.texels = words.back();
  }
  std::vector<Material> materials(scene.materials.begin(), scene.materials.end());
  for (Material& material : materials) material.lit = false;
  std::vector<Mesh> meshes(scene.meshes.begin(), scene.meshes.end());
  for (Mesh& mesh : meshes) mesh.colours = {};
  Scene numbered = scene;
  numbered.textures = textures;
  numbered.materials = materials;
  numbered.meshes = meshes;
  numbered.lights = {};
  const Drawn truth = draw<effects>(numbered, of.camera, view, budget);
  const PlanResult planned = plan(count(scene), view, effects, budget);
  std::vector<std::byte> arena = lent(planned.plan.bytes());
  Renderer<effects> renderer;
  EXPECT_TRUE(renderer.begin_frame(scene, of.camera, view, planned.plan, arena));
  int textured = 0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      Picked picked;
      EXPECT_TRUE(pick(renderer, static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), picked));
      if (!picked.textured) continue;
      ++textured;
      const int texel = (picked.v >> 12) * 16 + (picked.u >> 12);
      EXPECT_EQ(truth.at(x, y), 2 * texel + 1) << "pixel " << x << ", " << y;
      if (testing::Test::HasFailure()) return textured;
    }
  }
  return textured;
}

TEST(EffectsPick, ThePlaceInTheTextureIsThatOfTheTexelThatIsDrawn) {
  constexpr View kView{80, 64};
  constexpr Effects kTextured = effect::textures | effect::vertex_colours | effect::lighting;
  constexpr Effects kMasked = kTextured | effect::alpha_test | effect::texture_alpha;
  const Combination plain(effect::textures | effect::lighting), masked(kMasked);
  Combination level(effect::textures | effect::lighting | effect::orthographic);
  for (const Budget& budget : {kStreamed, kTiles}) {
    EXPECT_GT(expect_texels<kTextured>(plain, kView, budget), 500);
    EXPECT_GT(expect_texels<kTextured | effect::perspective_1>(plain, kView, budget), 500);
    EXPECT_GT(expect_texels<kTextured | effect::perspective_8>(plain, kView, budget), 500);
    EXPECT_GT(expect_texels<kTextured | effect::perspective_affine>(plain, kView, budget), 500);
    EXPECT_GT(expect_texels<kMasked>(masked, kView, budget), 500);
    EXPECT_GT(expect_texels<kTextured | effect::orthographic>(level, kView, budget), 500);
  }
}

/// Compares the pick of a renderer with its own picture of `ids`.
template <Effects effects>
void expect_ids_of(const IdScene& ids, const Combination& drawn, const View& view) {
  const Drawn truth = draw<effects>(ids.scene(), drawn.camera, view);
  const PlanResult planned = plan(count(drawn.scene), view, effects, kStreamed);
  std::vector<std::byte> arena = lent(planned.plan.bytes(), 0), strip = lent(planned.plan.strip_pixel_bytes(view));
  Renderer<effects> renderer;
  ASSERT_TRUE(renderer.begin_frame(drawn.scene, drawn.camera, view, planned.plan, arena));
  for (std::uint16_t y = 0; y < view.height; ++y) {
    ASSERT_TRUE(renderer.draw_strip(static_cast<std::uint16_t>(y / 7), strip));
    for (std::uint16_t x = 0; x < view.width; ++x) {
      Picked picked;
      ASSERT_TRUE(pick(renderer, x, y, picked));
      ASSERT_EQ(without_place(picked), ids.shown_by(truth.at(x, y))) << x << ", " << y;
    }
  }
}

TEST(EffectsPick, EveryDepthFormatPicksWhatItDraws) {
  constexpr Effects kSet = effect::textures | effect::lighting | effect::alpha_test | effect::texture_alpha;
  const Combination drawn(kSet);
  const IdScene ids(drawn.scene, drawn.camera);
  constexpr View kView{80, 64};
  expect_ids_of<kSet>(ids, drawn, kView);
  expect_ids_of<kSet | effect::depth_float>(ids, drawn, kView);
  expect_ids_of<kSet | effect::depth_24>(ids, drawn, kView);
  expect_ids_of<kSet | effect::depth_ranges>(ids, drawn, kView);
}

TEST(EffectsPick, OfSeveralSamplesThatAtTheCentreIsPicked) {
  // Lines and outlines have widths in pixels; billboards face the camera of the picture.
  constexpr Effects kOther =
      effect::overlay | effect::supersampled | effect::surfaces | effect::outlines | effect::billboards;
  const Effects set = completed(without(row(2), kOther));
  const Combination drawn(set);
  for (const std::uint8_t samples : {std::uint8_t{2}, kMaxSamples}) {
    const View view{40, 32, PixelFormat::rgb565, false, samples};
    const View all{80, static_cast<std::uint16_t>(samples == 2 ? 32 : 64)};
    Camera camera = drawn.camera;
    if (samples == 2) camera = detail::camera_of_samples(camera, view);
    const Effects effects = without(set, effect::dithered_colours | effect::dithered_format);
    const BegunFrame sampled(drawn.scene, drawn.camera, view, effects | effect::supersampled, kStreamed);
    const BegunFrame whole(drawn.scene, camera, all, effects, kStreamed);
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 40; ++x) {
        ASSERT_EQ(sampled.picked(x, y), whole.picked(2 * x + 1, samples == 2 ? y : 2 * y + 1)) << x << ", " << y;
      }
    }
    Picked picked;
    EXPECT_EQ(sampled.pick(40, 31, picked).error, Error::view_size);
  }
}

TEST(EffectsPick, TheTopmostPartOfTheOverlayThatAPixelShowsIsPicked) {
  const scenes::BuiltIn& knot = *scenes::find("knot");
  Scene scene = knot.scene;
  scene.overlay = &scenes::kKnotOverlay;
  constexpr View kView{160, 120};
  const Effects effects = effects_of(scene, knot.camera);
  const BegunFrame frame(scene, knot.camera, kView, effects, kStreamed);
  const BegunFrame without_overlay(knot.scene, knot.camera, kView, effects, kStreamed);
  const Overlay& overlay = scenes::kKnotOverlay;
  // Each element alone, over black and over white.
  std::vector<std::pair<Picked, std::vector<bool>>> elements;
  const auto add = [&](const Picked& picked, const Overlay& one) {
    std::vector<std::uint16_t> black(160 * 120, 0), white(160 * 120, 0xFFFF);
    draw_overlay(one, {0, 0, 160, 120}, black.data());
    draw_overlay(one, {0, 0, 160, 120}, white.data());
    std::vector<bool> covers;
    for (std::size_t i = 0; i < black.size(); ++i) covers.push_back(black[i] != 0 || white[i] != 0xFFFF);
    elements.emplace_back(picked, covers);
  };
  for (std::uint16_t i = 0; i < overlay.sprites.size(); ++i) {
    add({.shown = Shown::sprite, .index = i}, {.images = overlay.images, .sprites = overlay.sprites.subspan(i, 1)});
  }
  for (std::uint16_t i = 0; i < overlay.labels.size(); ++i) {
    add({.shown = Shown::label, .index = i}, {.fonts = overlay.fonts, .labels = overlay.labels.subspan(i, 1)});
  }
  int covered = 0;
  for (int y = 0; y < 120; y += 2) {
    for (int x = y / 2 % 2; x < 160; x += 2) {
      Picked wanted = without_overlay.picked(x, y);
      for (const auto& [picked, covers] : elements) {
        if (covers[static_cast<std::size_t>(y * 160 + x)]) wanted = picked;
      }
      covered += wanted.shown == Shown::sprite || wanted.shown == Shown::label ? 1 : 0;
      ASSERT_EQ(frame.picked(x, y), wanted) << x << ", " << y;
    }
  }
  EXPECT_GT(covered, 150);
}

TEST(EffectsPick, StripsAfterAPickAreThoseOfThePicture) {
  for (const Budget& budget : {kStreamed, kBinned}) {
    const Effects set = completed(without(row(3), effect::supersampled));
    const Combination drawn(set);
    const View view = view_of(set);
    const picture::Picture whole = picture::draw(set, drawn.scene, drawn.camera, view);
    BegunFrame frame(drawn.scene, drawn.camera, view, set, budget);
    const Plan plan = frame.renderer().frame().plan();
    std::vector<std::byte> strip = lent(plan.strip_pixel_bytes(view)), pixels(whole.pixels.size());
    std::mt19937 random(9);
    for (std::uint16_t i = 0; i < plan.strips; ++i) {
      for (int n = 0; n < 4; ++n) {
        (void)frame.picked(static_cast<int>(random() % view.width), static_cast<int>(random() % view.height));
      }
      ASSERT_TRUE(frame.renderer().draw_strip(i, strip));
      detail::copy_to_area(view.format, plan.strip_area(i, view), strip.data(), {0, 0, view.width, view.height},
                           pixels.data(), bytes_per_row(view.width, view.format));
    }
    EXPECT_EQ(pixels, whole.pixels);
  }
}

constexpr View kFixedView{40, 32, PixelFormat::rgb565};

TEST(EffectsPick, AFixedRendererPicksAsOthersDo) {
  FixedRenderer<scenes::mask.scene, kFixedView, kStreamed> renderer;
  ASSERT_TRUE(renderer.begin_frame(scenes::mask.camera));
  const BegunFrame frame(scenes::mask.scene, scenes::mask.camera, kFixedView, renderer.kEffects, kStreamed);
  for (std::uint16_t i = 0; i < 32; ++i) {
    Picked picked;
    ASSERT_TRUE(pick(renderer, i, i, picked));
    EXPECT_EQ(picked, frame.picked(i, i));
  }
}

// In a frame of one strip all meshlets of an instance were transformed, which took a quarter of the frame.
TEST(EffectsPick, MostMeshletsOfAFrameOfOneStripAreLeftOut) {
  std::mt19937 random(3);
  constexpr View kView{161, 119};
  for (const char* const name : {"teapot_meshlets", "knot_meshlets"}) {
    const scenes::BuiltIn& built_in = *scenes::find(name);
    const Mesh& mesh = built_in.scene.meshes[0];
    for (const int percent : {100, 30}) {
      SCOPED_TRACE(testing::Message() << name << ' ' << percent << " %");
      const Camera camera = closer(built_in.camera, percent);
      const BegunFrame frame(built_in.scene, camera, kView, effects_of(built_in.scene, camera), kWhole);
      const detail::StateOfFrame state_of(frame.frame());
      const auto& state = state_of.get<detail::FrameState>();
      std::size_t tested = 0, left_out = 0;
      for (int i = 0; i < 1000; ++i) {
        const int x = static_cast<int>(random() % kView.width), y = static_cast<int>(random() % kView.height);
        const int column = x - kView.width / 2, row = y - kView.height / 2;
        const detail::PixelPlanes planes(state.instances[0], mesh, state.origin, {column, row, column + 1, row + 1},
                                         false);
        const Picked picked = frame.picked(x, y);
        std::uint32_t end = 0;
        for (const Meshlet& meshlet : mesh.meshlets) {
          end += meshlet.triangle_count;
          const bool holds_it = picked.shown == Shown::instance && picked.triangle < end &&
                                picked.triangle >= end - meshlet.triangle_count;
          const bool misses = planes.miss(state.instances[0], meshlet);
          ASSERT_FALSE(holds_it && misses) << x << ',' << y;
          ++tested;
          left_out += misses ? 1U : 0U;
        }
      }
      EXPECT_GT(left_out * 100, tested * (percent == 100 ? 70 : 45));
    }
  }
}

TEST(EffectsPick, WhatCannotBePickedIsAnError) {
  Picked picked{.index = 7};
  const AnyRenderer idle(effect::lighting);
  EXPECT_EQ(picker_for(effect::lighting)(idle.frame(), 0, 0, picked).error, Error::not_begun);
  EXPECT_EQ(picked, Picked{});
  const Combination drawn(effect::lighting);
  const BegunFrame frame(drawn.scene, drawn.camera, {40, 32}, effect::lighting, kStreamed);
  EXPECT_TRUE(frame.pick(39, 31, picked));
  EXPECT_EQ(frame.pick(40, 31, picked).error, Error::view_size);
  EXPECT_EQ(frame.pick(39, 32, picked).error, Error::view_size);
  EXPECT_EQ(frame.pick(65535, 65535, picked).error, Error::view_size);
  const Combination products(effect::csg);
  const BegunFrame csg(products.scene, products.camera, {40, 32}, effect::csg, kStreamed);
  EXPECT_EQ(csg.pick(20, 16, picked), (Status{Error::csg, Purpose::none, 2, 0}));
  EXPECT_EQ(picker_for(effect::depth_24)(frame.frame(), 0, 0, picked).error, Error::depth_effects);
  EXPECT_EQ(picker_for(effect::textures | effect::perspective_1)(frame.frame(), 0, 0, picked).error,
            Error::depth_effects);
  EXPECT_EQ(picker_for(effect::depth_24 | effect::depth_float)(frame.frame(), 0, 0, picked).error,
            Error::depth_effects);
  EXPECT_EQ(picker_for(method::front_to_back)(frame.frame(), 0, 0, picked).error, Error::visibility);
}

}  // namespace
}  // namespace effects_test
