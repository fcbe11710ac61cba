// A static layer with things that move over it: the same pictures as if everything were drawn in every frame, and no
// tile drawn that did not change.
#include "zstrip/layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "picture.hpp"

namespace {

using namespace zstrip;
using picture::Model;
using picture::random_model;

constexpr View kView{100, 70, PixelFormat::rgb565};  // neither side a multiple of 8
constexpr std::size_t kPixels = 100 * 70;

/// One mesh each; drawn in one scene, the background first, or each alone.
class Layers {
 public:
  Layers() : background_(random_model(21, 60, 14000)), moving_(random_model(22, 12, 20000)) {
    for (Model* model : {&background_, &moving_}) model->texels.clear();
    background_.instance.transform.m[2][3] = -kFixedOne;
    for (int i = 0; i < 3; ++i) moving_.instance.transform.m[i][i] = kFixedOne / 4;
    camera.near_plane = kFixedOne;
    camera.far_plane = 6 * kFixedOne;
    camera.fixed_depth_range = true;
    const Scene first = background_.scene();
    const Scene second = moving_.scene();
    meshes_ = {first.meshes[0], second.meshes[0]};
    materials_ = {first.materials[0], second.materials[0]};
    instances_ = {first.instances[0], second.instances[0]};
    instances_[1].mesh = instances_[1].material = 1;
    light_ = first.lights[0];
  }
  void move(Fixed x, Fixed y, Fixed z) {
    Transform& t = instances_[1].transform;
    t.m[0][3] = x;
    t.m[1][3] = y;
    t.m[2][3] = z;
  }
  Scene scene(std::size_t first, std::size_t count) const {
    Scene scene;
    scene.meshes = meshes_;
    scene.materials = materials_;
    scene.instances = std::span(instances_).subspan(first, count);
    scene.lights = {&light_, 1};
    scene.background = {16, 32, 48, 255};
    return scene;
  }
  Camera camera;

 private:
  Model background_, moving_;
  std::array<Mesh, 2> meshes_;
  std::array<Material, 2> materials_;
  std::array<Instance, 2> instances_;
  DirectionalLight light_;
};

/// A renderer with the memory of its plan.
class Drawn {
 public:
  Drawn(const Scene& scene, const Camera& camera, const Budget& budget, const View& view = kView)
      : renderer(effects_of(scene, camera)),
        plan(zstrip::plan(count(scene), view, effects_of(scene, camera) | effect::bins, budget).plan) {
    arena_ = picture::lent(plan.bytes());
    pixels = picture::lent(plan.strip_pixel_bytes(view));
  }
  Status begin(const Scene& scene, const Camera& camera, const View& view = kView) {
    return renderer.begin_frame(scene, camera, view, plan, arena_);
  }
  AnyRenderer renderer;
  Plan plan;
  std::vector<std::byte> pixels;

 private:
  std::vector<std::byte> arena_;
};

std::vector<std::uint16_t> whole_picture(const Scene& scene, const Camera& camera) {
  return rgb565_of(picture::render(scene, camera, kView, kView.height));
}

struct LayerMemory {
  std::vector<std::byte> depth = std::vector<std::byte>(store_bytes_worst(100, 70));
  std::vector<std::byte> colour = std::vector<std::byte>(store_bytes_worst(100, 70));
  std::vector<std::uint32_t> dirty = std::vector<std::uint32_t>(dirty_tile_words(100, 70));
  StaticLayer::Memory all() { return {depth, colour, dirty}; }
};

/// Draws the background and keeps its strips, up to the first that cannot be kept.
Status keep_background(StaticLayer& layer, const Layers& layers) {
  const Scene scene = layers.scene(0, 1);
  Drawn background(scene, layers.camera, {.strip_rows = 16});
  Status kept;
  const auto keep = [&](std::uint16_t strip, std::span<const std::byte> pixels) {
    if (kept) kept = layer.keep(background.renderer.frame(), strip, pixels);
  };
  EXPECT_TRUE(picture::draw(background.renderer, scene, layers.camera, kView, background.plan, {}, keep).status);
  return kept;
}

/// Draws what is dirty into `screen`; returns how many pixels that were.
std::size_t redraw(StaticLayer& layer, AnyRenderer& renderer, std::uint32_t cells, std::vector<std::uint16_t>& screen) {
  std::vector<std::uint16_t> pixels(cells), depth(cells);
  std::vector<int> sent(kPixels, 0);
  Rect area;
  while (layer.next(area, cells)) {
    EXPECT_LE(static_cast<std::uint32_t>(area.width() * area.height()), cells);
    EXPECT_TRUE(layer.restore(area, pixels, depth));
    EXPECT_TRUE(renderer.draw_over(area, pixels, depth));
    for (int y = area.top; y < area.bottom; ++y) {
      for (int x = area.left; x < area.right; ++x) {
        const auto at = static_cast<std::size_t>(y * kView.width + x);
        screen[at] = pixels[static_cast<std::size_t>((y - area.top) * area.width() + x - area.left)];
        EXPECT_EQ(++sent[at], 1) << "drawn twice: " << x << ',' << y;
      }
    }
  }
  return static_cast<std::size_t>(std::count(sent.begin(), sent.end(), 1));
}

class StaticLayers : public testing::TestWithParam<Budget> {};

TEST_P(StaticLayers, FramesAreThoseOfTheWholeScene) {
  Layers layers;
  LayerMemory memory;
  StaticLayer layer;
  ASSERT_TRUE(layer.reset(memory.all(), kView));
  ASSERT_TRUE(keep_background(layer, layers));
  Drawn moving(layers.scene(1, 1), layers.camera, GetParam());
  std::vector<std::uint16_t> screen(kPixels, 0xDEAD);
  for (int frame = 0; frame < 12; ++frame) {
    layers.move((frame - 6) * kFixedOne / 4, frame * kFixedOne / 16, -frame * kFixedOne / 5);
    if (frame == 9) layers.move(40 * kFixedOne, 0, 0);  // out of sight
    const Scene scene = layers.scene(1, 1);
    ASSERT_TRUE(moving.begin(scene, layers.camera));
    layer.move_to(moving.renderer.frame().bounds());
    const std::size_t drawn = redraw(layer, moving.renderer, 64U + 200U * static_cast<unsigned>(frame), screen);
    ASSERT_EQ(screen, whole_picture(layers.scene(0, 2), layers.camera)) << frame;
    if (frame == 0) {
      EXPECT_EQ(drawn, kPixels);
    } else {
      EXPECT_LT(drawn, kPixels / 4) << frame;
    }
  }
  const Scene scene = layers.scene(1, 1);
  ASSERT_TRUE(moving.begin(scene, layers.camera));
  layer.move_to({});
  redraw(layer, moving.renderer, 512, screen);
  EXPECT_EQ(redraw(layer, moving.renderer, 512, screen), 0U) << "nothing moved";
}

INSTANTIATE_TEST_SUITE_P(Plans, StaticLayers,
                         testing::Values(Budget{}, Budget{.strip_rows = 5},
                                         Budget{.strip_rows = 9, .strip_columns = 24, .modes = Modes::streamed},
                                         Budget{.strip_rows = 9, .strip_columns = 24, .modes = Modes::binned}),
                         [](const auto& test) { return "Plan" + std::to_string(test.index); });

TEST(StaticLayer, RefusesWhatItCannotKeep) {
  Layers layers;
  LayerMemory memory;
  StaticLayer layer;
  ASSERT_TRUE(layer.reset(memory.all(), kView));
  const Scene scene = layers.scene(0, 1);
  Drawn odd(scene, layers.camera, {.strip_rows = 5});
  ASSERT_TRUE(odd.begin(scene, layers.camera));
  ASSERT_TRUE(odd.renderer.draw_strip(1, odd.pixels));
  EXPECT_EQ(layer.keep(odd.renderer.frame(), 1, odd.pixels).error, Error::store_range);
  EXPECT_EQ(layer.keep(odd.renderer.frame(), 14, odd.pixels).error, Error::strip_rows);
  Drawn fitting(scene, layers.camera, {.strip_rows = 8});
  ASSERT_TRUE(fitting.begin(scene, layers.camera));
  ASSERT_TRUE(fitting.renderer.draw_strip(0, fitting.pixels));
  EXPECT_EQ(layer.keep(fitting.renderer.frame(), 0, std::span(fitting.pixels).first(1599)).error,
            Error::pixels_too_small);
  const View other{100, 72};
  Drawn larger(scene, layers.camera, {.strip_rows = 8}, other);
  ASSERT_TRUE(larger.begin(scene, layers.camera, other));
  ASSERT_TRUE(larger.renderer.draw_strip(0, larger.pixels));
  EXPECT_EQ(layer.keep(larger.renderer.frame(), 0, larger.pixels).error, Error::store_range);
  AnyRenderer wide(effects_of(scene, layers.camera) | effect::depth_24);
  const Plan plan = zstrip::plan(count(scene), kView, effects_of(scene, layers.camera) | effect::depth_24).plan;
  std::vector<std::uint64_t> words(plan.bytes() / 8);
  std::vector<std::byte> pixels(plan.strip_pixel_bytes(kView));
  ASSERT_TRUE(wide.begin_frame(scene, layers.camera, kView, plan, std::as_writable_bytes(std::span(words))));
  ASSERT_TRUE(wide.draw_strip(0, pixels));
  EXPECT_EQ(layer.keep(wide.frame(), 0, pixels).error, Error::depth_effects);
  std::vector<std::uint16_t> cells(64);
  EXPECT_EQ(wide.draw_over({0, 0, 8, 8}, cells, cells).error, Error::depth_effects);
  EXPECT_EQ(fitting.renderer.draw_over({0, 0, 9, 8}, cells, cells).error, Error::pixels_too_small);
  EXPECT_EQ(fitting.renderer.draw_over({96, 0, 104, 8}, cells, cells).error, Error::view_size);
  EXPECT_EQ(layer.restore({1, 0, 9, 8}, cells, cells).error, Error::store_range);
  EXPECT_EQ(layer.restore({0, 0, 16, 8}, cells, cells).error, Error::pixels_too_small);
}

TEST(StaticLayer, PoolsThatAreTooSmallSaySo) {
  Layers layers;
  LayerMemory memory;
  const std::size_t worst = memory.depth.size();
  int full = 0, enough = 0;
  for (std::size_t bytes = worst; bytes > 0; bytes = bytes * 4 / 5) {
    memory.depth.resize(bytes);
    StaticLayer layer;
    if (const Status status = layer.reset(memory.all(), kView); !status) {
      EXPECT_EQ(status.error, Error::store_full);
      continue;
    }
    const Status kept = keep_background(layer, layers);
    if (kept) ++enough;
    if (!kept) {
      EXPECT_EQ(kept.error, Error::store_full);
      EXPECT_GT(kept.needed, kept.available);
      ++full;
    }
  }
  EXPECT_GT(enough, 1) << "compression saves a fifth";
  EXPECT_GT(full, 1);
}

}  // namespace
