// Strips that fingerprints leave out: the glass of a panel that is sent only what changed shows, after every frame of
// the project's scenes, what another one shows that is sent every strip.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <vector>

#include "bench.hpp"
#include "render/edged_stage.hpp"
#include "render/stage.hpp"
#include "zstrip/fingerprints.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_hal/changed_tiles.hpp"

namespace zstrip::panels {
namespace {

constexpr View kView{96, 80, zstrip::PixelFormat::rgb565_swapped};
constexpr std::uint32_t kFrames = 48;  // of a motion; neighbours differ by as much as on a panel
constexpr std::uint16_t kRows = 8;
constexpr std::uint16_t kStrips = kView.height / kRows;

/// Draws frames whole, and of those that a panel knows only what it does not.
class Drawer {
 public:
  Drawer() : changes_(both_[0].display) {
    for (auto& bench : both_) EXPECT_EQ(bench.display.start(), Error::none);
  }

  /// Draws a frame for both panels; `fails`: a write to the one that is sent changes fails. Returns the strips that
  /// were drawn for it, if none failed.
  std::size_t draw(const Scene& scene, const Camera& camera, std::uint32_t version, bool fails = false) {
    const Effects effects = effects_of(scene, camera) | effects_of(kView) | effect::bins;
    const PlanResult planned = plan(count(scene), kView, effects, {.strip_rows = kRows});
    EXPECT_TRUE(planned.status);
    arena_.resize(planned.plan.bytes() / sizeof(std::uint64_t) + 1);
    AnyRenderer renderer(effects);
    const Status begun =
        renderer.begin_frame(scene, camera, kView, planned.plan, std::as_writable_bytes(std::span(arena_)));
    EXPECT_TRUE(begun) << message(begun.error);
    const hal::StripLayout layout{planned.plan.strips, planned.plan.strip_rows, planned.plan.strip_columns};
    if (fails)
      both_[0].bus.fail_at(both_[0].bus.transfers() + static_cast<int>(random_() % 12),
                           static_cast<unsigned>(random_() % 5));
    Known known(renderer, camera, version);
    failed_ = hal::present(known, changes_, layout, buffers()).display != Error::none;
    both_[0].bus.fail_at(-1, 0);
    EXPECT_TRUE(hal::present(renderer, both_[1].display, layout, buffers()));
    return known.drawn;
  }
  bool failed() const { return failed_; }
  /// What differs between the panels; empty if nothing does.
  std::string fault() const {
    for (const auto& bench : both_) {
      if (!bench.panel->complaints().empty()) return bench.panel->complaints().front();
    }
    return difference(picture_of(both_[0].panel->seen()), picture_of(both_[1].panel->seen()));
  }
  std::uint64_t bytes(int which) const { return both_[which].bus.bytes(); }
  void forget() { changes_.forget(); }

 private:
  using KnownFrame = FingerprintedFrame<AnyRenderer, kStrips>;
  struct Known : KnownFrame {
    using KnownFrame::KnownFrame;
    std::size_t drawn = 0;
    Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
      ++drawn;
      return KnownFrame::draw_strip(strip, pixels);
    }
  };
  static hal::DcsConfig panel() { return {.width = kView.width, .height = kView.height}; }
  hal::StripBuffers buffers() {
    return {std::as_writable_bytes(std::span(first_)), std::as_writable_bytes(std::span(second_))};
  }

  Bench<St7789> both_[2]{Bench<St7789>(panel()), Bench<St7789>(panel())};
  hal::ChangedTiles<St7789::Driver, hal::changed_tiles({kStrips, kRows}, kView.width)> changes_;
  std::vector<std::uint64_t> arena_;
  std::vector<std::uint32_t> first_ = std::vector<std::uint32_t>(kView.width * kRows / 2), second_ = first_;
  std::mt19937 random_{3};
  bool failed_ = false;
};

/// All scene files, and built-in scenes of the gallery.
std::vector<std::filesystem::path> scene_files() {
  std::vector<std::filesystem::path> files{"teapot", "knot_meshlets", "room", ZSTRIP_SCENE_FILES "/figure/figure.gltf"};
  for (const char* const folder : {ZSTRIP_SCENE_FILES, ZSTRIP_SCENE_FILES "/gallery"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

std::unique_ptr<sim::Stage> opened(const std::filesystem::path& file, std::uint32_t frames = kFrames) {
  auto stage = sim::open_stage(file.string(), {}, {}, kView, frames);
  EXPECT_TRUE(stage) << file << ": " << (stage ? "" : stage.failure().message);
  return stage ? std::move(*stage) : nullptr;
}

class ChangedScene : public testing::TestWithParam<std::filesystem::path> {};
std::string name_of(const testing::TestParamInfo<std::filesystem::path>& info) { return info.param.stem().string(); }
INSTANTIATE_TEST_SUITE_P(Files, ChangedScene, testing::ValuesIn(scene_files()), name_of);

/// Neighbouring frames, the same one again, and distant ones; with ZSTRIP_LONG then every frame of the motion. A write
/// fails now and then.
void expect_the_glass_of_all_strips(sim::Stage& stage) {
  Drawer drawer;
  int step = 0;
  std::vector<std::uint32_t> frames{0, 1, 2, 3, 3, 4, 20, 21, 21, 0, 1};
  if (std::getenv("ZSTRIP_LONG") != nullptr) {
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) frames.push_back(frame);
  }
  for (const std::uint32_t frame : frames) {
    const auto staging = stage.place(frame, kFrames);
    ASSERT_TRUE(staging);
    (void)drawer.draw(staging->scene, staging->camera, staging->version, step++ % 3 == 2);
    if (drawer.failed()) (void)drawer.draw(staging->scene, staging->camera, staging->version);
    ASSERT_FALSE(drawer.failed());
    ASSERT_EQ(drawer.fault(), "") << "frame " << frame;
  }
}

TEST_P(ChangedScene, TheGlassShowsInEveryFrameWhatAllStripsShow) {
  const auto stage = opened(GetParam());
  ASSERT_NE(stage, nullptr);
  expect_the_glass_of_all_strips(*stage);
}

/// Edges are blended with neighbours, which may be another instance's.
TEST(ChangedScenes, TheGlassShowsEdgesBesideWhatMoves) {
  for (const char* const scene : {"train", "watch", "home"}) {
    auto stage =
        sim::with_edges(opened(std::string(ZSTRIP_SCENE_FILES "/gallery/").append(scene).append(".toml")), true, kView);
    ASSERT_TRUE(stage);
    expect_the_glass_of_all_strips(**stage);
  }
}

/// One thing after the other changes a little.
TEST_P(ChangedScene, NothingThatChangesIsLeftOut) {
  const auto stage = opened(GetParam());
  ASSERT_NE(stage, nullptr);
  const auto staging = stage->place(5, kFrames);
  ASSERT_TRUE(staging);
  Scene scene = staging->scene;
  Camera camera = staging->camera;
  std::vector<Instance> instances(scene.instances.begin(), scene.instances.end());
  std::vector<Material> materials(scene.materials.begin(), scene.materials.end());
  std::vector<Finish> finishes(scene.finishes.begin(), scene.finishes.end());
  std::vector<DirectionalLight> lights(scene.lights.begin(), scene.lights.end());
  std::vector<PunctualLight> lamps(scene.punctual_lights.begin(), scene.punctual_lights.end());
  std::vector<Quadric> quadrics(scene.quadrics.begin(), scene.quadrics.end());
  std::vector<LineSet> lines(scene.lines.begin(), scene.lines.end());
  scene.instances = instances, scene.materials = materials, scene.finishes = finishes, scene.lights = lights;
  scene.punctual_lights = lamps, scene.quadrics = quadrics, scene.lines = lines;
  Fog fog = scene.fog != nullptr ? *scene.fog : Fog{};
  if (scene.fog != nullptr) scene.fog = &fog;
  char text[] = "12:34";
  const Font fonts[]{kSmallFont};
  Label labels[]{{.text = text, .x = 20, .y = 30}};
  const Overlay overlay{.images = {}, .fonts = fonts, .sprites = {}, .labels = labels};

  Drawer drawer;
  const auto expect_whole = [&](const char* what) {
    (void)drawer.draw(scene, camera, staging->version);
    EXPECT_EQ(drawer.fault(), "") << what;
  };
  expect_whole("the first frame");
  camera.eye.x += 500, expect_whole("the camera's place");
  camera.focal += camera.focal / 64, expect_whole("its focal length");
  scene.ambient.g ^= 0x40, expect_whole("ambient light");
  scene.background.b ^= 0x20, expect_whole("the background");
  for (DirectionalLight& light : lights) light.colour.r ^= 0x80, expect_whole("a light");
  for (PunctualLight& lamp : lamps) lamp.position.y += 0x8000, expect_whole("a lamp");
  fog.end += fog.end / 8, fog.density += fog.density / 8, expect_whole("fog");
  for (Material& material : materials) material.colour.r ^= 0x60, expect_whole("a material");
  for (Finish& finish : finishes) finish.emissive.g ^= 0x40, expect_whole("a finish");
  const auto move = [](Transform& transform) { transform.m[1][3] += 0x0C00; };
  for (std::size_t i = 0; i < std::min<std::size_t>(instances.size(), 12); ++i) {
    move(instances[i * instances.size() / std::min<std::size_t>(instances.size(), 12)].transform);
    expect_whole("an instance");
  }
  for (Quadric& quadric : quadrics) move(quadric.transform), expect_whole("a quadric");
  for (LineSet& set : lines) move(set.transform), expect_whole("lines");
  if (!instances.empty() && scene.csg.empty())
    scene.instances = std::span(instances).first(instances.size() - 1), expect_whole("fewer");
  if (scene.overlay == nullptr && scene.csg.empty()) {
    scene.overlay = &overlay, expect_whole("an overlay");
    text[4] = '5', expect_whole("its text");
    labels[0].y = 60, expect_whole("its place");
    labels[0].colour.r = 0, expect_whole("its colour");
    scene.overlay = nullptr, expect_whole("no overlay");
  }
}

/// What cannot be known is drawn: outlines, and skins that move while they are drawn.
TEST_P(ChangedScene, AFrameThatIsDrawnAgainDrawsNoStrip) {
  const auto stage = opened(GetParam());
  ASSERT_NE(stage, nullptr);
  const auto staging = stage->place(0, kFrames);
  ASSERT_TRUE(staging);
  Drawer drawer;
  EXPECT_EQ(drawer.draw(staging->scene, staging->camera, staging->version), kStrips);
  const bool outlined = !staging->scene.outlines.empty();
  if (!outlined) {
    EXPECT_EQ(drawer.draw(staging->scene, staging->camera, staging->version), 0U);
  }
  drawer.forget();
  EXPECT_EQ(drawer.draw(staging->scene, staging->camera, staging->version), kStrips);
}

// A dithered view dithers its background if there is fog.
TEST(ChangedStrips, ABackgroundIsDrawnAgainWhenFogBegins) {
  constexpr View kDithered{96, 80, zstrip::PixelFormat::rgb565, true};
  const Fog fog{.end = 1 << 16};
  Scene scene;
  const auto print = [&] {
    const Effects effects = effect::fog | effects_of(kDithered);
    const PlanResult planned = plan(count(scene), kDithered, effects, {.strip_rows = kRows});
    EXPECT_TRUE(planned.status);
    std::vector<std::uint64_t> arena(planned.plan.bytes() / sizeof(std::uint64_t) + 1);
    AnyRenderer renderer(effects);
    EXPECT_TRUE(
        renderer.begin_frame(scene, Camera{}, kDithered, planned.plan, std::as_writable_bytes(std::span(arena))));
    return StripFingerprints<1>(renderer.frame(), Camera{})[0];
  };
  const std::uint32_t clear = print();
  scene.fog = &fog;
  EXPECT_NE(print(), clear);
}

/// A small thing that moves in a large picture: strips beside it are neither drawn nor sent.
TEST(ChangedStrips, OnlyStripsThatAMovingInstanceTouchesAreDrawn) {
  constexpr Position kCorners[]{{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}};
  constexpr Triangle kTriangles[]{{0, 1, 2}};
  Mesh mesh{
      .positions = kCorners, .normals = {}, .colours = {}, .texcoords = {}, .triangles = kTriangles, .meshlets = {}};
  mesh.half_extent = {kFixedOne / 8, kFixedOne / 8, 0};
  const Material material{.lit = false};
  Instance instances[2];
  instances[0].transform.m[1][3] = kFixedOne;   // above
  instances[1].transform.m[1][3] = -kFixedOne;  // below
  const Scene scene{
      .meshes = {&mesh, 1}, .materials = {&material, 1}, .textures = {}, .instances = instances, .lights = {}};
  Camera camera;
  Drawer drawer;
  EXPECT_EQ(drawer.draw(scene, camera, 0), kStrips);
  EXPECT_EQ(drawer.draw(scene, camera, 0), 0U);
  instances[1].transform.m[0][3] += kFixedOne / 16;
  const std::size_t drawn = drawer.draw(scene, camera, 0);
  EXPECT_GE(drawn, 1U);
  EXPECT_LE(drawn, 3U);
  EXPECT_EQ(drawer.fault(), "");
  EXPECT_EQ(drawer.draw(scene, camera, 1), 4U) << "both, as tables may have changed, but not the background";
}

}  // namespace
}  // namespace zstrip::panels
