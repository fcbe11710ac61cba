// Several samples a pixel: what they take, what the frame says of them, and what is refused.
#include "samples.hpp"
#include "zstrip/layer.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/room.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test::samples_plan_test {
namespace {

TEST(Supersampling, APlanHasWhatAFrameTakesAndNoByteMore) {
  scenes::Staged staged;
  scenes::stage(scenes::knot, staged, 3, 20, kPixels);
  const SceneCounts counts = count(staged.scene);
  for (const PixelFormat format : {PixelFormat::rgb565, PixelFormat::mono}) {
    for (const int samples : {2, 4}) {
      const View view = with_samples(kPixels, samples, format);
      const Effects effects = effects_of(staged.scene, staged.camera) | effects_of(view);
      const Plan planned = plan(counts, view, effects, {.strip_rows = 8}).plan;
      EXPECT_EQ(planned.depth_bytes, 75U * 8 * 2 * static_cast<unsigned>(samples));
      EXPECT_EQ(planned.colour_bytes, 75U * 8 * 2 * static_cast<unsigned>(samples));
      const Plan plain = plan(counts, {75, 58, format}, effects, {.strip_rows = 8}).plan;
      EXPECT_EQ(planned.bytes() - planned.depth_bytes - planned.colour_bytes,
                plain.bytes() - plain.depth_bytes - plain.colour_bytes);
    }
  }
}

TEST(Supersampling, LessMemoryGivesLowerStripsOfTheSamePixels) {
  scenes::Staged staged;
  scenes::stage(scenes::room, staged, 3, 20, kPixels);
  const View view = with_samples(kPixels, 4);
  const Effects effects = effects_of(staged.scene, staged.camera) | effects_of(view);
  const Plan whole = plan(count(staged.scene), view, effects).plan;
  EXPECT_EQ(whole.strips, 1);
  const Budget budget{.bytes = whole.bytes() / 3};
  const Plan less = plan(count(staged.scene), view, effects, budget).plan;
  EXPECT_LE(less.bytes(), budget.bytes);
  EXPECT_GT(less.strips, 1);
  EXPECT_EQ(bytes_of(effects, staged.scene, staged.camera, view, budget),
            bytes_of(effects, staged.scene, staged.camera, view));
}

TEST(Supersampling, TheFrameSaysPixels) {
  scenes::Staged staged;
  scenes::stage(scenes::cube, staged, 3, 20, kPixels);
  for (const int samples : {1, 2, 4}) {
    const View view = with_samples(kPixels, samples);
    constexpr Effects kEffects = effects_of(scenes::cube.scene, scenes::cube.camera) | effect::supersampled;
    const Plan planned = plan(count(staged.scene), view, kEffects, {.strip_rows = 8, .strip_columns = 16}).plan;
    const auto check = [&](auto&& renderer) {
      const std::vector<std::uint8_t> bytes = bytes_by(renderer, staged.scene, staged.camera, view, planned);
      EXPECT_EQ(renderer.frame().view().width, view.width);
      EXPECT_EQ(renderer.frame().view().height, view.height);
      EXPECT_EQ(renderer.frame().plan().strip_rows, 8);
      EXPECT_EQ(renderer.frame().plan().strip_columns, 16);
      EXPECT_EQ(renderer.frame().has_plain_depth(), samples == 1);
      const Rect bounds = renderer.frame().bounds();
      EXPECT_LT(bounds.right - bounds.left, view.width);
      for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
          if (x >= bounds.left && x < bounds.right && y >= bounds.top && y < bounds.bottom) continue;
          const std::size_t at = 2 * static_cast<std::size_t>(y * view.width + x);
          ASSERT_EQ(bytes[at], bytes[0]) << x << ", " << y;
          ASSERT_EQ(bytes[at + 1], bytes[1]) << x << ", " << y;
        }
      }
    };
    check(Renderer<kEffects>());
    check(AnyRenderer(kEffects));
  }
}

TEST(Supersampling, WhatCannotBeIsRefused) {
  scenes::Staged staged;
  scenes::stage(scenes::cube, staged, 3, 20, kPixels);
  constexpr Effects kPlain = effects_of(scenes::cube.scene, scenes::cube.camera);
  constexpr Effects kEffects = kPlain | effect::supersampled;
  const SceneCounts counts = count(staged.scene);
  const View four = with_samples(kPixels, 4);
  const Plan planned = plan(counts, four, kEffects).plan;
  std::vector<std::uint64_t> arena(planned.bytes() / 8);
  std::vector<std::uint64_t> pixels(planned.strip_pixel_bytes(four) / 8 + 1);
  const auto begin = [&](auto& renderer, const Camera& camera, const View& view, const Plan& given) {
    return renderer.begin_frame(staged.scene, camera, view, given, std::as_writable_bytes(std::span(arena)));
  };
  // Without the effect, by plans and by renderers; what they drew before is gone.
  const Status missing = effects_missing(effect::supersampled);
  EXPECT_EQ(plan(counts, four, kPlain).status, missing);
  const auto refuses = [&](auto&& renderer) {
    EXPECT_TRUE(begin(renderer, staged.camera, kPixels, plan(counts, kPixels, kPlain).plan));
    EXPECT_EQ(begin(renderer, staged.camera, four, planned), missing);
    EXPECT_EQ(renderer.draw_strip(0, std::as_writable_bytes(std::span(pixels))).error, Error::not_begun);
  };
  refuses(Renderer<kPlain>());
  refuses(AnyRenderer(kPlain));
  refuses(AnyRenderer(kPlain | effect::fog));
  // Numbers of samples that are none.
  Renderer<kEffects> renderer;
  for (const int samples : {0, 3, 5, 8, 255}) {
    const View view = with_samples(kPixels, samples);
    const Status none{.error = Error::samples, .needed = static_cast<std::uint32_t>(samples)};
    EXPECT_EQ(plan(counts, view, kEffects).status, none);
    EXPECT_EQ(begin(renderer, staged.camera, view, planned), none);
  }
  // More samples than a picture can have.
  EXPECT_TRUE(plan(counts, {2048, 1, PixelFormat::rgb565, false, 2}, kEffects).status);
  EXPECT_TRUE(plan(counts, {1, 4096, PixelFormat::rgb565, false, 2}, kEffects).status);
  for (const View view : {View{2049, 1, PixelFormat::rgb565, false, 2}, View{1, 2049, PixelFormat::rgb565, false, 4},
                          View{2049, 7, PixelFormat::rgb565, false, 4}}) {
    const Status many{.error = Error::view_size, .needed = 4098, .available = 4096};
    EXPECT_EQ(plan(counts, view, kEffects).status, many);
    EXPECT_EQ(begin(renderer, staged.camera, view, planned), many);
  }
  // A focal length that two samples cannot double.
  Camera longest = staged.camera;
  longest.focal = INT32_MAX / 2 + 1;
  const View two = with_samples(kPixels, 2);
  EXPECT_EQ(begin(renderer, longest, two, plan(counts, two, kEffects).plan).error, Error::camera);
  // Strips that are split within bytes of some format, rows that are not there.
  Plan split = planned;
  split.strip_columns = 12;
  split.strips = 7;
  EXPECT_EQ(begin(renderer, staged.camera, four, split),
            (Status{.error = Error::strip_columns, .needed = 12, .available = 75}));
  Plan high = planned;
  high.strip_rows = 59;
  EXPECT_EQ(begin(renderer, staged.camera, four, high),
            (Status{.error = Error::strip_rows, .needed = 59, .available = 58}));
  // Buffers of a strip.
  ASSERT_TRUE(begin(renderer, staged.camera, four, planned));
  const auto bytes = std::as_writable_bytes(std::span(pixels));
  EXPECT_TRUE(renderer.draw_strip(0, bytes.first(75 * 58 * 2)));
  EXPECT_EQ(renderer.draw_strip(0, bytes.first(75 * 58 * 2 - 1)),
            (Status{.error = Error::pixels_too_small, .needed = 75 * 58 * 2, .available = 75 * 58 * 2 - 1}));
  EXPECT_EQ(renderer.draw_strip(0, bytes.subspan(1, 75 * 58 * 2)).error, Error::pixels_misaligned);
  EXPECT_EQ(renderer.draw_strip(1, bytes).error, Error::strip_rows);
}

TEST(Supersampling, StaticLayersHaveOneSample) {
  scenes::Staged staged;
  scenes::stage(scenes::cube, staged, 3, 20, kPixels);
  const View view = with_samples(kPixels, 4);
  constexpr Effects kEffects = effects_of(scenes::cube.scene, scenes::cube.camera) | effect::supersampled;
  EXPECT_EQ(plan(count(staged.scene), view, kEffects, {.strip_rows = 8, .layer = layer_bytes_worst(view)}).status,
            (Status{.error = Error::samples, .needed = 4}));
  const Plan planned = plan(count(staged.scene), view, kEffects, {.strip_rows = 8}).plan;
  std::vector<std::byte> arena = lent(planned.bytes());
  Renderer<kEffects> renderer;
  ASSERT_TRUE(renderer.begin_frame(staged.scene, staged.camera, view, planned, arena));
  std::vector<std::uint16_t> pixels(2 * 150 * 16);
  ASSERT_TRUE(renderer.draw_strip(0, std::as_writable_bytes(std::span(pixels))));
  std::vector<std::uint16_t> depth(64);
  EXPECT_EQ(renderer.draw_over({0, 0, 8, 8}, pixels, depth), (Status{.error = Error::samples, .needed = 4}));
  // Not even one that is as large as the picture of samples.
  for (const View size : {View{75, 58}, View{150, 116}}) {
    const std::uint32_t pool = store_bytes_worst(size.width, size.height);
    std::vector<std::byte> depths(pool), colours(pool);
    std::vector<std::uint32_t> dirty(dirty_tile_words(size.width, size.height));
    StaticLayer layer;
    ASSERT_TRUE(layer.reset({depths, colours, dirty}, size));
    EXPECT_EQ(layer.keep(renderer.frame(), 0, std::as_bytes(std::span(pixels))).error, Error::depth_effects);
  }
}

}  // namespace
}  // namespace effects_test::samples_plan_test
