// Pictures with several samples a pixel: the means of a picture of so many pixels that was drawn without them.
#include <array>

#include "dither_oracle.hpp"
#include "lines_scene.hpp"
#include "samples.hpp"
#include "zstrip/effects/billboards/billboard.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/spheres.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test::samples_test {
namespace {

/// Rows and columns of samples in a pixel.
struct Grid {
  int columns, rows;
};
Grid grid_of(int samples) { return {2, samples / 2}; }

/// The view in which every sample is a pixel.
View all_samples(const View& view, int samples) {
  const Grid grid = grid_of(samples);
  return {static_cast<std::uint16_t>(view.width * grid.columns), static_cast<std::uint16_t>(view.height * grid.rows),
          PixelFormat::rgb565, view.dither && !is_narrow(view.format)};
}

/// A focal length counts halves of the height: where only columns are doubled, it has to make up for that.
Camera for_all_samples(Camera camera, int samples) {
  if (samples != 2) return camera;
  camera.focal *= 2;
  for (std::int32_t* const part : {&camera.up.x, &camera.up.y, &camera.up.z}) {
    *part = (*part - (*part & 1)) / 2;
  }
  return camera;
}

struct Channels {
  int r, g, b;
};
Channels channels(int pixel) { return {pixel / 2048, pixel / 32 % 64, pixel % 32}; }

/// RGB565 of each pixel from a picture of its samples.
std::vector<int> means(const Drawn& samples, const View& view) {
  const Grid grid = grid_of(view.samples);
  const int count = view.samples;
  std::vector<int> pixels;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      Channels sum{0, 0, 0};
      for (int i = 0; i < grid.rows; ++i) {
        for (int j = 0; j < grid.columns; ++j) {
          const Channels c = channels(samples.at(x * grid.columns + j, y * grid.rows + i));
          sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
        }
      }
      constexpr int kOrder2[2][2] = {{0, 2}, {3, 1}};
      const int added = view.dither && !is_narrow(view.format) ? kOrder2[y / 2 % 2][x / 2 % 2] * count / 4 : count / 2;
      pixels.push_back((sum.r + added) / count * 2048 + (sum.g + added) / count * 32 + (sum.b + added) / count);
    }
  }
  return pixels;
}

/// A row of pixels in a format, by docs/conventions.md.
void append_row(std::vector<std::uint8_t>& bytes, const std::vector<int>& pixels, std::size_t first, const View& view,
                int y) {
  int bits = 0, held = 0;
  const auto put = [&](int value, int width) {
    for (int i = width - 1; i >= 0; --i) {
      held = held * 2 + (value >> i) % 2;
      if (++bits % 8 == 0) bytes.push_back(static_cast<std::uint8_t>(held)), held = 0;
    }
  };
  for (int x = 0; x < view.width; ++x) {
    const int pixel = pixels[first + static_cast<std::size_t>(x)];
    const Channels c = channels(pixel);
    const int r = c.r * 8 + c.r / 4, g = c.g * 4 + c.g / 16, b = c.b * 8 + c.b / 4;
    const int grey = (77 * r + 150 * g + 29 * b + 128) / 256;
    const auto narrowed = [&](int value, int to) {
      return view.dither ? dither_oracle::level(value, to, x, y) : value >> (8 - to);
    };
    switch (view.format) {
      case PixelFormat::rgb565: put(pixel % 256, 8), put(pixel / 256, 8); break;
      case PixelFormat::rgb565_swapped: put(pixel, 16); break;
      case PixelFormat::gray4: put(narrowed(grey, 4), 4); break;
      case PixelFormat::mono: put(narrowed(grey, 1), 1); break;
      case PixelFormat::rgb666: put(r / 4 * 4, 8), put(g / 4 * 4, 8), put(b / 4 * 4, 8); break;
      case PixelFormat::rgb444: put(narrowed(r, 4), 4), put(narrowed(g, 4), 4), put(narrowed(b, 4), 4); break;
      case PixelFormat::xrgb8888: put(b, 8), put(g, 8), put(r, 8), put(0, 8); break;
    }
  }
  while (bits % 8 != 0) put(0, 1);
}

std::vector<std::uint8_t> in_format(const std::vector<int>& pixels, const View& view) {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < view.height; ++y) {
    append_row(bytes, pixels, static_cast<std::size_t>(y) * view.width, view, y);
  }
  return bytes;
}

/// What the scene with `view` must be: `reference` is the scene as it is drawn in a picture of samples.
std::vector<std::uint8_t> expected(Effects effects, const Scene& reference, const Camera& camera, const View& view) {
  const View whole = all_samples(view, view.samples);
  const Effects own = without(effects, effect::supersampled | effect::dithered_format | effect::dithered_colours);
  const Drawn samples = draw_any(own | effects_of(whole), reference, for_all_samples(camera, view.samples), whole);
  return in_format(means(samples, view), view);
}

void expect_means(const scenes::BuiltIn& built_in, Effects more = {}) {
  SCOPED_TRACE(built_in.name);
  scenes::Staged staged;
  scenes::stage(built_in, staged, 3, 20, kPixels);
  for (const int samples : {2, 4}) {
    SCOPED_TRACE(samples);
    const View view = with_samples(kPixels, samples);
    const Effects effects = effects_of(staged.scene, staged.camera) | effects_of(view) | more;
    EXPECT_TRUE(effects.has(effect::supersampled));
    const std::vector<std::uint8_t> whole = expected(effects, staged.scene, staged.camera, view);
    EXPECT_EQ(bytes_of(effects, staged.scene, staged.camera, view), whole);
    EXPECT_EQ(bytes_of(effects, staged.scene, staged.camera, view, {.strip_rows = 1}), whole);
    EXPECT_EQ(bytes_of(effects, staged.scene, staged.camera, view, {.strip_rows = 7, .strip_columns = 24}), whole);
    EXPECT_NE(bytes_of(effects, staged.scene, staged.camera, kPixels), whole) << "no edge to soften";
    if (more.methods == 0 && !more.has(effect::depth_ranges)) {
      const Budget binned{.strip_rows = 9, .strip_columns = 40, .modes = Modes::binned};
      EXPECT_EQ(bytes_of(effects | effect::bins, staged.scene, staged.camera, view, binned), whole);
    }
  }
}

TEST(Supersampling, PicturesAreTheMeansOfTheirSamples) {
  expect_means(scenes::knot);
  expect_means(scenes::room);
  expect_means(scenes::spheres);
  for (const scenes::BuiltIn& built_in : scenes::effect_scenes()) expect_means(built_in);
}

TEST(Supersampling, BillboardsTurnToThePictureNotToItsSamples) {
  scenes::Staged staged;
  scenes::stage(scenes::knot, staged, 3, 20, kPixels);
  for (const Billboard billboard : {Billboard::viewer, Billboard::upright}) {
    Mesh mesh = staged.scene.meshes[0];
    mesh.billboard = billboard;
    Scene billboards = staged.scene, by_hand = staged.scene;
    billboards.meshes = {&mesh, 1};
    Instance turned = staged.scene.instances[0];
    turned.transform = detail::turned_to_viewer(turned.transform, billboard, staged.camera);
    by_hand.instances = {&turned, 1};
    for (const int samples : {2, 4}) {
      const View view = with_samples(kPixels, samples);
      const Effects effects = effects_of(billboards, staged.camera) | effects_of(view);
      ASSERT_TRUE(effects.has(effect::billboards | effect::supersampled));
      EXPECT_EQ(bytes_of(effects, billboards, staged.camera, view, {.strip_rows = 9}),
                expected(without(effects, effect::billboards), by_hand, staged.camera, view))
          << samples;
    }
  }
}

TEST(Supersampling, InEveryDepthFormatAndWithMethods) {
  for (const Effects depth :
       {effect::depth_float, effect::depth_24, effect::depth_ranges, effect::perspective_1, effect::statistics}) {
    expect_means(scenes::room, depth);
  }
  for (const Effects method :
       {method::front_to_back, method::hierarchical_z, method::painter, method::painter | method::in_order,
        method::midpoint_safe, method::hierarchical_z | method::culling}) {
    SCOPED_TRACE(method.methods);
    expect_means(scenes::knot, method);
  }
}

TEST(Supersampling, InEveryFormatDitheredOrNot) {
  scenes::Staged staged;
  scenes::stage(scenes::fog, staged, 3, 20, kPixels);
  const Effects own = effects_of(staged.scene, staged.camera);
  for (int format = 0; format <= static_cast<int>(kLastPixelFormat); ++format) {
    for (const bool dither : {false, true}) {
      for (const int samples : {2, 4}) {
        SCOPED_TRACE(testing::Message() << format << (dither ? " dithered " : " ") << samples);
        const View view = with_samples(kPixels, samples, static_cast<PixelFormat>(format), dither);
        const Effects effects = own | effects_of(view) | effect::bins;
        const std::vector<std::uint8_t> whole = expected(own, staged.scene, staged.camera, view);
        EXPECT_EQ(bytes_of(effects, staged.scene, staged.camera, view), whole);
        EXPECT_EQ(bytes_of(effects, staged.scene, staged.camera, view, {.strip_rows = 5, .strip_columns = 16}), whole);
      }
    }
  }
}

TEST(Supersampling, WithEitherProjectionAndOddSizes) {
  scenes::Staged staged;
  scenes::stage(scenes::spheres, staged, 3, 20, kPixels);
  for (const View size : {View{1, 1}, View{1, 40}, View{33, 41}, View{64, 3}}) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      Camera camera = staged.camera;
      camera.projection = projection;
      if (projection == Projection::orthographic) camera.focal = fixed(0.6);
      for (const int samples : {2, 4}) {
        const View view = with_samples(size, samples);
        const Effects effects = effects_of(staged.scene, camera) | effects_of(view);
        EXPECT_EQ(bytes_of(effects, staged.scene, camera, view, {.strip_rows = 1}),
                  expected(effects, staged.scene, camera, view))
            << size.width << " x " << size.height << ", " << samples;
      }
    }
  }
}

TEST(Supersampling, ItsOwnPipelineDrawsWhatTheHostsDo) {
  scenes::Staged staged;
  scenes::stage(scenes::knot, staged, 3, 20, kPixels);
  constexpr View kView = with_samples(kPixels, 4);
  constexpr Effects kEffects = effects_of(scenes::knot.scene, scenes::knot.camera) | effects_of(kView);
  const Drawn whole = draw<kEffects>(staged.scene, staged.camera, kView);
  EXPECT_EQ(draw<kEffects>(staged.scene, staged.camera, kView, {.strip_rows = 11, .strip_columns = 32}), whole);
  EXPECT_EQ(draw_any(kEffects, staged.scene, staged.camera, kView), whole);
  // A renderer that can average draws a picture of one sample as ever.
  EXPECT_EQ(draw<kEffects>(staged.scene, staged.camera, kPixels),
            draw_any(without(kEffects, effect::supersampled), staged.scene, staged.camera, kPixels));
}

TEST(Supersampling, LinesAreAsWideAsPixelsSay) {
  scenes::Staged staged;
  scenes::stage(scenes::lines, staged, 3, 20, kPixels);
  std::vector<LineSet> twice(staged.scene.lines.begin(), staged.scene.lines.end());
  for (LineSet& lines : twice) lines.width = static_cast<std::uint8_t>(2 * lines.width);
  Scene reference = staged.scene;
  reference.lines = twice;
  const View view = with_samples(kPixels, 4);
  const Effects effects = effects_of(staged.scene, staged.camera) | effects_of(view);
  const std::vector<std::uint8_t> whole = expected(effects, reference, staged.camera, view);
  EXPECT_EQ(bytes_of(effects, staged.scene, staged.camera, view), whole);
  EXPECT_EQ(bytes_of(effects, staged.scene, staged.camera, view, {.strip_rows = 3, .strip_columns = 16}), whole);
}

/// One white line in a picture of 64 x 64 pixels, its ends in 1/16 pixels from the middle, +y up.
struct OneLine {
  Position positions[2];
  Segment segments[1] = {{0, 1}};
  LineSet lines{};
  Mesh mesh;
  Material material{.colour = {255, 255, 255, 255}, .lit = false};
  Camera camera;
  Scene scene;

  OneLine(int ax, int ay, int bx, int by, int width) {
    // Half of the picture's height, 512 sixteenths, is 1.
    const auto coordinate = [](int sixteenths) { return static_cast<std::int16_t>(sixteenths * 64); };
    positions[0] = {coordinate(ax), coordinate(ay), 0};
    positions[1] = {coordinate(bx), coordinate(by), 0};
    mesh.positions = positions;
    mesh.half_extent = {kFixedOne, kFixedOne, kFixedOne};
    lines = {.segments = segments, .width = static_cast<std::uint8_t>(width)};
    camera.projection = Projection::orthographic;
    camera.focal = kFixedOne;
    scene.meshes = {&mesh, 1};
    scene.materials = {&material, 1};
    scene.lines = {&lines, 1};
  }
};

// Two samples are half a pixel wide and a pixel high. What docs/conventions.md says of lines is asked of each sample's
// centre, in 1/32 pixels across and 1/16 pixels down, in which ends are snapped.
TEST(Supersampling, LinesOfTwoSamplesAreThoseOfTheirDefinition) {
  constexpr int kEnds[][4] = {{-300, -100, 250, 131}, {-120, -300, 140, 300}, {-90, 300, 170, -290},
                              {-200, 7, 200, 7},      {3, -200, 3, 200},      {-200, -200, 200, 200},
                              {-130, 250, -10, -7},   {-70, -65, 12, 88},     {100, 100, 116, 130}};
  constexpr View kView{64, 64, PixelFormat::rgb565, false, 2};
  for (const auto& [ax, ay, bx, by] : kEnds) {
    for (const int width : {1, 3}) {
      OneLine one(ax, ay, bx, by, width);
      const Drawn drawn =
          draw_any(effect::lines | effect::orthographic | effect::supersampled, one.scene, one.camera, kView);
      // In units of 1/32 pixel from the upper left corner: x then y.
      const std::int64_t x0 = 1024 + 2 * ax, y0 = 1024 - 2 * ay, x1 = 1024 + 2 * bx, y1 = 1024 - 2 * by;
      const bool along_x = std::abs(x1 - x0) >= std::abs(y1 - y0);
      const auto covered = [&](std::int64_t column, std::int64_t row) {
        const std::int64_t cx = 16 * column + 8, cy = 32 * row + 16, half_cell = along_x ? 8 : 16;
        std::int64_t low = along_x ? x0 : y0, from = along_x ? y0 : x0, high = along_x ? x1 : y1,
                     to = along_x ? y1 : x1;
        if (low > high) std::swap(low, high), std::swap(from, to);
        const std::int64_t along = along_x ? cx : cy, across = along_x ? cy : cx;
        if (along + half_cell < low || along - half_cell > high) return 0;    // not in this cell
        if (along + half_cell == low || along - half_cell == high) return 2;  // ends on a border: either
        const std::int64_t at = std::clamp(along, low, high), length = std::max<std::int64_t>(high - low, 1);
        // p - width / 2 < c <= p + width / 2, p = from + (to - from) (at - low) / length; times 2 length.
        const std::int64_t p = 2 * from * length + 2 * (to - from) * (at - low), c = 2 * across * length;
        const std::int64_t half = 32 * width * length;
        if (c == p - half || c == p + half) return 2;
        return p - half < c && c < p + half ? 1 : 0;
      };
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
          const int first = covered(2 * x, y), second = covered(2 * x + 1, y);
          if (first == 2 || second == 2) continue;
          const int level = std::array{0, 16, 31}[static_cast<std::size_t>(first + second)];
          ASSERT_EQ(drawn.at(x, y) & 31, level) << ax << ' ' << ay << ' ' << bx << ' ' << by << " at " << x << ' ' << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace effects_test::samples_test
