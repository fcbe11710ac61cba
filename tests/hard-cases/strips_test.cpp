// Hard cases E: strips and the bounding rectangle never show in a picture.
// Cases 55 to 58 are in store_test.cpp.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "depth_picture.hpp"
#include "generators.hpp"
#include "space.hpp"

namespace hard_cases {
namespace {

using picture::DepthPicture;

/// How to draw what must always be the same picture.
struct Way {
  Budget budget;
  bool small_bins = false;  ///< so that they overflow, in most scenes
  std::uint8_t garbage = 0;
  bool backwards = false;
  Effects depth{};  ///< how depth is kept
};

/// Memory between bytes that nobody may change.
class Guarded {
 public:
  Guarded(std::size_t size, std::byte filled) : filled_(filled), size_(size), bytes_(size + 2 * kGuard, filled) {}
  std::span<std::byte> span() { return std::span(bytes_).subspan(kGuard, size_); }
  bool intact() const {
    const auto is_filled = [&](std::byte b) { return b == filled_; };
    return std::all_of(bytes_.begin(), bytes_.begin() + kGuard, is_filled) &&
           std::all_of(bytes_.end() - kGuard, bytes_.end(), is_filled);
  }

 private:
  static constexpr std::ptrdiff_t kGuard = 64;
  static_assert(kGuard % kArenaAlignment == 0);
  std::byte filled_;
  std::size_t size_;
  std::vector<std::byte> bytes_;
};

/// A renderer that draws each strip into guarded memory.
struct GuardedRenderer : AnyRenderer {
  using AnyRenderer::AnyRenderer;
  Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    Guarded memory(pixels.size(), pixels.front());
    const Status status = AnyRenderer::draw_strip(strip, memory.span());
    RC_ASSERT(memory.intact());
    std::ranges::copy(memory.span(), pixels.begin());
    return status;
  }
};

/// Draws strip by strip with buffers full of garbage, and checks that nothing outside arena and pixels is written.
DepthPicture draw_in_strips(const Scene& scene, const Camera& camera, const View& view, const Way& way) {
  const Effects effects = effects_of(scene, camera) | effect::bins | way.depth;
  const PlanResult planned = plan(count(scene), view, effects, way.budget);
  RC_ASSERT(planned.status);
  Plan p = planned.plan;
  if (p.mode == Mode::binned && way.small_bins) {
    const SceneCounts counts = count(scene);
    p.bin_bytes = std::min(
        p.bin_bytes, detail::rounded_up(counts.meshlets * kBatchBytes + p.strips * kBinBytes + 2 * kBinChunkBytes));
  }
  Guarded arena(p.bytes(), std::byte{way.garbage});
  GuardedRenderer renderer(effects);
  DepthPicture drawn =
      picture::draw_with_depth(renderer, effects, scene, camera, view, p,
                               {.garbage = way.garbage, .last_strip_first = way.backwards, .arena = arena.span()});
  RC_ASSERT(drawn.status);
  RC_ASSERT(arena.intact());
  return drawn;
}

/// A random scene: any effects, the camera outside it or among its triangles.
struct AnyScene {
  Model model;
  std::vector<Meshlet> meshlets;
  Camera camera;
  View view;

  AnyScene() {
    model = picture::random_model(static_cast<unsigned>(between(0, 1'000'000)), between(1, 60),
                                  between(0, 1) == 0 ? 1500 : 20000);
    if (between(0, 1) == 0) {
      model.material.texture = 0;
    } else {
      model.texels.clear();
    }
    model.material.lit = between(0, 1) == 0;
    model.material.smooth = between(0, 1) == 0;
    if (between(0, 2) == 0) camera.projection = Projection::orthographic;
    if (between(0, 2) == 0) camera.eye = {between(-60000, 60000), between(-60000, 60000), between(-60000, 60000)};
    view = {static_cast<std::uint16_t>(between(1, 70)), static_cast<std::uint16_t>(between(1, 50)),
            static_cast<PixelFormat>(between(0, 6))};
    // Every triangle has three vertices of its own, so that any run of them is a meshlet.
    const int length = between(0, 9);
    const auto triangles = static_cast<int>(model.triangles.size());
    for (int first = 0; length != 0 && first < triangles; first += length) {
      const auto count = static_cast<std::uint16_t>(std::min(length, triangles - first));
      meshlets.push_back({static_cast<std::uint32_t>(first),
                          static_cast<std::uint16_t>(3 * first),
                          static_cast<std::uint16_t>(3 * count),
                          count,
                          0,
                          {}});
    }
  }
  /// Refers to this object.
  Scene scene() {
    Scene scene = model.scene();
    model.mesh.meshlets = meshlets;
    return scene;
  }
};

RC_GTEST_PROP(HardCases, E51_StripHeightChangesNeitherPixelNorDepth, ()) {
  AnyScene any;
  const Scene scene = any.scene();
  const DepthPicture whole = draw_in_strips(scene, any.camera, any.view, {.budget = {.modes = Modes::streamed}});
  for (const int rows : {1, 2, 3, 7, 8, 16}) {
    if (rows > any.view.height) break;
    const Way way{.budget = {.strip_rows = static_cast<std::uint16_t>(rows), .modes = Modes::streamed},
                  .garbage = static_cast<std::uint8_t>(between(0, 255)),
                  .backwards = between(0, 1) == 1};
    const DepthPicture strips = draw_in_strips(scene, any.camera, any.view, way);
    RC_ASSERT((strips.pixels == whole.pixels));
    RC_ASSERT((strips.depth == whole.depth));
  }
}

RC_GTEST_PROP(HardCases, E51_BinsColumnsAndOverflowChangeNeitherPixelNorDepth, ()) {
  AnyScene any;
  const Scene scene = any.scene();
  Effects depth{};
  if (any.camera.projection == Projection::perspective) {
    constexpr Effects kFormats[] = {{}, effect::depth_float, effect::depth_24};
    depth = kFormats[static_cast<std::size_t>(between(0, static_cast<int>(std::size(kFormats)) - 1))];
  }
  any.model.material.depth_bias = static_cast<decltype(any.model.material.depth_bias)>(between(0, 1) * 5);
  const DepthPicture whole =
      draw_in_strips(scene, any.camera, any.view, {.budget = {.modes = Modes::streamed}, .depth = depth});
  const int across = (any.view.width + 7) / 8;
  for (const Modes modes : {Modes::streamed, Modes::binned}) {
    for (const bool small_bins : {false, true}) {
      const int columns = 8 * between(1, across);
      const Way way{.budget = {.strip_rows = static_cast<std::uint16_t>(between(1, any.view.height)),
                               .strip_columns = static_cast<std::uint16_t>(std::min<int>(columns, any.view.width)),
                               .modes = modes},
                    .small_bins = small_bins,
                    .garbage = static_cast<std::uint8_t>(between(0, 255)),
                    .backwards = between(0, 1) == 1,
                    .depth = depth};
      RC_LOG() << "binned " << (modes == Modes::binned) << ", small bins " << small_bins << ", strips of "
               << way.budget.strip_columns << " x " << way.budget.strip_rows << " in " << any.view.width << " x "
               << any.view.height << ", format " << static_cast<int>(any.view.format) << '\n';
      const DepthPicture strips = draw_in_strips(scene, any.camera, any.view, way);
      RC_ASSERT((strips.pixels == whole.pixels));
      RC_ASSERT((strips.depth == whole.depth));
    }
  }
}

RC_GTEST_PROP(HardCases, E52_VerticesAndEdgesExactlyOnStripBorders, ()) {
  // Every corner on a multiple of 8 rows, or within a sub-pixel of one.
  const auto row = [] { return between(0, 8) * 128 + between(-1, 1); };
  const auto column = [] { return between(-100, kView.width * 16 + 100); };
  std::vector<Corners2> triangles;
  Lattice lattice;
  lattice.model().material.double_sided = true;
  for (int i = 0; i < 3; ++i) {
    triangles.push_back({{{column(), row()}, {column(), row()}, {column(), row()}}});
    lattice.add(triangles.back());
  }
  RC_ASSERT(coverage_verdict(triangles) == "");
  const Picture whole = lattice.draw();
  for (const std::uint16_t rows : {std::uint16_t{8}, std::uint16_t{1}, std::uint16_t{4}, std::uint16_t{16}}) {
    const Picture strips = lattice.draw(rows);
    RC_ASSERT((strips.pixels == whole.pixels));
    RC_ASSERT(strips.statistics.fragments == whole.statistics.fragments);
  }
}

RC_GTEST_PROP(HardCases, E53_NothingIsLeftOfEarlierFrames, ()) {
  // Objects move, leave and come back; one arena for all frames.
  Model model = picture::random_model(static_cast<unsigned>(between(0, 1'000'000)), 12, 9000);
  model.texels.clear();
  const View view{64, 48};
  const Camera camera;
  Scene scene = model.scene();
  const Effects effects = effects_of(scene, camera);
  const Plan p = plan(count(scene), view, effects, {.strip_rows = 16}).plan;
  std::vector<std::byte> arena = picture::lent(p.bytes());
  AnyRenderer renderer(effects);
  for (int frame = 0; frame < 8; ++frame) {
    for (int axis = 0; axis < 3; ++axis) model.instance.transform.m[axis][3] = between(-4 * kFixedOne, 4 * kFixedOne);
    const Picture fresh = picture::render(scene, camera, view, 16);
    const Picture drawn = picture::draw(renderer, scene, camera, view, p, {.arena = arena});
    RC_ASSERT(drawn.status);
    RC_ASSERT((drawn.pixels == fresh.pixels));
  }
}

TEST(HardCases, E53_AnEmptySceneIsBackground) {
  Scene scene;
  scene.background = {255, 0, 0, 255};
  const Picture picture = picture::render(scene, Camera{}, View{17, 9}, 4);
  ASSERT_TRUE(picture.status);
  EXPECT_TRUE(picture.bounds.empty());
  for (int i = 0; i < 17 * 9; ++i) ASSERT_EQ(pixel_at(picture, i % 17, i / 17, 17), 0xF800);
}

TEST(HardCases, E54_RectanglesOfNoOneAndAllPixelsAndCutByEachSide) {
  // A square of `size` sub-pixels wanders over the picture and beyond it.
  for (const int size : {2, 16, 40, 16 * 16, 96 * 16, 1000 * 16, 2000 * 16}) {
    const int step = size > 1000 * 16 ? 2 : 1;  // in position steps, the largest do not fit 16 bits otherwise
    for (int x = -size - 32; x <= kView.width * 16 + 32; x += std::max(size / 6 * 2, 98)) {
      for (int y = -size - 32; y <= kView.height * 16 + 32; y += std::max(size / 6 * 2, 102)) {
        const std::vector<Corners2> square{{{{x, y}, {x + size, y}, {x + size, y + size}}},
                                           {{{x, y}, {x + size, y + size}, {x, y + size}}}};
        ASSERT_EQ(coverage_verdict(square, step), "");
        Lattice lattice(step);
        lattice.model().material.double_sided = true;
        for (const Corners2& t : square) lattice.add(t);
        const Picture picture = lattice.draw(5);
        const Rect b = picture.bounds;
        ASSERT_TRUE(b.empty() || (b.left >= 0 && b.top >= 0 && b.right <= kView.width && b.bottom <= kView.height));
        for (int i = 0; i < kPixels; ++i) {
          if (pixel_at(picture, i % kView.width, i / kView.width) == 0) continue;
          ASSERT_TRUE(i % kView.width >= b.left && i % kView.width < b.right && i / kView.width >= b.top &&
                      i / kView.width < b.bottom);
        }
      }
    }
  }
}

TEST(HardCases, E54_PicturesOfEverySizeUpToTheLargest) {
  for (const View view :
       {View{1, 1}, View{1, 4096}, View{4096, 1}, View{1000, 1000}, View{2000, 2000}, View{4096, 4096}}) {
    Space space(kFixedOne, 2 * kFixedOne);
    space.view = view;
    space.add({{{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}}});
    const Picture picture = space.draw(view.height > 100 ? 100 : 0);
    ASSERT_TRUE(picture.status);
    const oracle::SpaceTriangle exact = space.exact({0, 1, 2}, 0.15L);
    for (int y = 0; y < view.height; y += 1 + view.height / 257) {
      for (int x = 0; x < view.width; x += 1 + view.width / 259) {
        const oracle::Verdict verdict = exact.sees(x, y);
        if (verdict == oracle::Verdict::abstains) continue;
        ASSERT_EQ(pixel_at(picture, x, y, view.width) != 0, verdict == oracle::Verdict::inside)
            << view.width << ' ' << x << ',' << y;
      }
    }
  }
}

}  // namespace
}  // namespace hard_cases
