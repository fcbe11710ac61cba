// Overlays against an oracle: every format, clipped at every side, in strips of any size, over samples, edges and
// dithering; text of any bytes; and what is refused.
#include "zstrip/overlay.hpp"

#include <cstring>
#include <random>
#include <string>
#include <string_view>

#include "edges_scene.hpp"
#include "overlay_oracle.hpp"
#include "overlay_scene.hpp"
#include "samples.hpp"
#include "zstrip/effects/dithering/dither.hpp"
#include "zstrip/effects/overlay/utf8.hpp"
#include "zstrip/resolve/convert.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test {
namespace {

constexpr Effects kPlain = effects_of(scenes::knot.scene, scenes::knot.camera);
constexpr Effects kOver = effects_of(scenes::overlay.scene, scenes::overlay.camera);
static_assert(kOver == (kPlain | effect::overlay));

/// The knot and an overlay, which may change.
struct World {
  scenes::Staged staged;
  explicit World(const Overlay* overlay, const View& view = kPixels) {
    stage(scenes::overlay, staged, 3, 20, view);
    staged.scene.overlay = overlay;
  }
  Scene without() const {
    Scene plain = staged.scene;
    plain.overlay = nullptr;
    return plain;
  }
};

std::span<const char> chars(std::string_view text) { return {text.data(), text.size()}; }

/// Images, fonts and text of random bytes, and where they lie.
struct RandomOverlay {
  std::mt19937 random;
  std::vector<std::vector<std::uint8_t>> bytes;
  std::vector<std::vector<std::uint16_t>> words;
  std::vector<std::vector<Glyph>> glyphs;
  std::vector<std::string> texts;
  std::vector<OverlayImage> images;
  std::vector<Font> fonts;
  std::vector<Sprite> sprites;
  std::vector<Label> labels;
  Overlay overlay;

  explicit RandomOverlay(unsigned seed) : random(seed) {
    for (int i = 0; i < 8; ++i) add_image(i);
    for (const int bits : {1, 4, 8}) add_font(static_cast<std::uint8_t>(bits));
    for (int i = 0; i < 12; ++i) {
      sprites.push_back({place(-30, 85), place(-30, 70), static_cast<std::uint16_t>(below(8)), colour()});
    }
    for (int i = 0; i < 6; ++i) texts.push_back(text());
    for (const std::string& each : texts) {
      labels.push_back({.text = chars(each),
                        .x = place(-20, 95),
                        .y = place(-30, 70),
                        .font = static_cast<std::uint16_t>(below(3)),
                        .alignment = static_cast<Alignment>(below(3)),
                        .colour = colour(),
                        .background = below(2) == 0 ? Colour{} : colour()});
    }
    overlay = {images, fonts, sprites, labels};
  }

  int below(int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); }
  std::int16_t place(int first, int end) { return static_cast<std::int16_t>(first + below(end - first)); }
  std::uint8_t byte() { return static_cast<std::uint8_t>(below(4) == 0 ? 255 * below(2) : below(256)); }
  Colour colour() { return {byte(), byte(), byte(), byte()}; }
  std::span<const std::uint8_t> coverage(std::size_t size) {
    std::vector<std::uint8_t>& all = bytes.emplace_back(size);
    for (std::uint8_t& each : all) each = byte();
    return all;
  }
  void add_image(int i) {
    OverlayImage image{.width = static_cast<std::uint16_t>(1 + below(40)),
                       .height = static_cast<std::uint16_t>(1 + below(40)),
                       .coverage_bits = static_cast<std::uint8_t>(i % 4 == 0   ? 1
                                                                  : i % 4 == 1 ? 4
                                                                               : 8)};
    const auto pixels = static_cast<std::size_t>(image.width) * image.height;
    const bool has_colours = i >= 4 || i == 3, has_coverage = i != 3;
    if (has_colours) {
      std::vector<std::uint16_t>& all = words.emplace_back(pixels);
      for (std::uint16_t& each : all) each = static_cast<std::uint16_t>(random());
      image.colours = all;
    }
    if (has_coverage)
      image.coverage = coverage(static_cast<std::size_t>((image.width * image.coverage_bits + 7) / 8) * image.height);
    images.push_back(image);
  }
  void add_font(std::uint8_t bits) {
    std::vector<Glyph>& all = glyphs.emplace_back();
    Font font{.coverage_bits = bits, .line_height = static_cast<std::uint16_t>(3 + below(12))};
    font.baseline = static_cast<std::uint16_t>(below(font.line_height + 1));
    std::uint32_t end = 0;
    for (const std::uint32_t point : {0x20U, 0x41U, 0x42U, 0x5AU, 0xC4U, 0x20ACU, 0xFFFDU, 0x1F600U}) {
      if (point == 0xFFFD && bits == 4) continue;  // what is missing is not shown there
      const int height = below(3 * font.line_height + 1);
      const int first = below(3 * font.line_height - height + 1) - font.line_height;
      const auto width = static_cast<std::uint8_t>(below(14));
      all.push_back({point, end, width, static_cast<std::uint8_t>(height), place(-5, 6),
                     static_cast<std::int16_t>(font.baseline - first), static_cast<std::uint16_t>(below(14))});
      end += static_cast<std::uint32_t>((width * bits + 7) / 8 * height);
    }
    font.glyphs = all;
    font.coverage = coverage(end);
    fonts.push_back(font);
  }
  std::string text() {
    static const std::string kPieces[] = {
        "A", "B",        "Z ",   "\xC3\x84", "\xE2\x82\xAC", "\xF0\x9F\x98\x80", "\n",  "\xEF\xBF\xBD",
        "q", "\xE2\x82", "\xFF", "\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\n\n"};
    std::string text;
    for (int i = below(20); i > 0; --i) text += kPieces[below(static_cast<int>(std::size(kPieces)))];
    if (below(4) == 0) text += std::string(1, '\0') + "AAA";
    return text;
  }
};

TEST(Overlays, AreWhatTheOracleSaysInAnyStrips) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    RandomOverlay over(seed);
    ASSERT_TRUE(validate(over.overlay));
    const World world(&over.overlay);
    const Scene& scene = world.staged.scene;
    const Drawn plain = draw<kPlain>(world.without(), world.staged.camera, kPixels);
    const Drawn expected = overlay_oracle::over(plain, over.overlay);
    EXPECT_EQ(draw<kOver>(scene, world.staged.camera, kPixels), expected) << seed;
    EXPECT_EQ(draw<kOver>(world.without(), world.staged.camera, kPixels), plain);
    for (const int rows : {1, 7, 29}) {
      const int columns = rows == 1 ? 75 : rows == 7 ? 8 : 40;
      EXPECT_EQ(draw<kOver>(scene, world.staged.camera, kPixels,
                            {.strip_rows = static_cast<std::uint16_t>(rows),
                             .strip_columns = static_cast<std::uint16_t>(columns)}),
                expected)
          << seed << ", " << rows << " rows, " << columns << " columns";
    }
  }
}

/// Every alpha, coverage and pair of levels of a channel.
TEST(Overlays, BlendExactly) {
  for (int alpha = 0; alpha < 256; ++alpha) {
    std::vector<std::uint16_t> under(64 * 64), colours(64 * 64);
    for (int i = 0; i < 64 * 64; ++i) {
      const int own = i % 64, other = i / 64;
      colours[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(own / 2 * 2048 + own * 32 + own % 32);
      under[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(other % 32 * 2048 + other * 32 + other / 2);
    }
    const OverlayImage images[] = {{.width = 64, .height = 64, .colours = colours}};
    const Sprite sprites[] = {{.colour = {0, 0, 0, static_cast<std::uint8_t>(alpha)}}};
    const Overlay overlay{.images = images, .fonts = {}, .sprites = sprites, .labels = {}};
    const Drawn before{64, 64, under};
    draw_overlay(overlay, {0, 0, 64, 64}, under.data());
    ASSERT_EQ((Drawn{64, 64, under}), overlay_oracle::over(before, overlay)) << alpha;
  }
  // Coverage times alpha.
  std::vector<std::uint8_t> coverage(256);
  for (std::size_t i = 0; i < 256; ++i) coverage[i] = static_cast<std::uint8_t>(i);
  const OverlayImage images[] = {{.width = 256, .height = 1, .coverage = coverage}};
  for (int alpha = 0; alpha < 256; ++alpha) {
    const Sprite sprites[] = {{.colour = {255, 255, 255, static_cast<std::uint8_t>(alpha)}}};
    const Overlay overlay{.images = images, .fonts = {}, .sprites = sprites, .labels = {}};
    std::vector<std::uint16_t> pixels(256, 0);
    draw_overlay(overlay, {0, 0, 256, 1}, pixels.data());
    ASSERT_EQ((Drawn{256, 1, pixels}), overlay_oracle::over({256, 1, std::vector<std::uint16_t>(256, 0)}, overlay));
  }
}

TEST(Overlays, AreClippedAtEverySide) {
  const std::vector<std::uint16_t> colours(20 * 20, 0x1234);
  const OverlayImage images[] = {{.width = 20, .height = 20, .colours = colours}};
  constexpr int kWidth = 16, kHeight = 12;
  for (const int x : {-32768, -20, -19, -5, 0, 5, 15, 16, 32767}) {
    for (const int y : {-32768, -20, -19, -5, 0, 5, 11, 12, 32767}) {
      const Sprite sprites[] = {{.x = static_cast<std::int16_t>(x), .y = static_cast<std::int16_t>(y)}};
      const Overlay overlay{.images = images, .fonts = {}, .sprites = sprites, .labels = {}};
      // Exactly the strip's memory, so that a sanitizer sees the first pixel beyond it.
      std::vector<std::uint16_t> pixels(kWidth * kHeight, 0);
      draw_overlay(overlay, {0, 0, kWidth, kHeight}, pixels.data());
      EXPECT_EQ((Drawn{kWidth, kHeight, pixels}),
                overlay_oracle::over({kWidth, kHeight, std::vector<std::uint16_t>(pixels.size(), 0)}, overlay))
          << x << ", " << y;
    }
  }
}

TEST(Overlays, TextIsUtf8AndAnyByte) {
  std::mt19937 random(5);
  std::vector<std::string> texts;
  for (std::uint32_t lead = 0; lead < 256; ++lead) {
    for (const char second : {'\x7F', '\x80', '\x8F', '\x90', '\x9F', '\xA0', '\xBF', '\xC0'}) {
      texts.push_back({static_cast<char>(lead), second, '\x80', '\xBF', 'x'});
      texts.push_back({static_cast<char>(lead), second, '\x80', 'y', '\x80'});
    }
  }
  for (int i = 0; i < 2000; ++i) {
    std::string& text = texts.emplace_back();
    for (unsigned n = random() % 8; n > 0; --n)
      text += static_cast<char>(random() % 3 == 0 ? random() : 0x80 | random());
  }
  for (const std::string& text : texts) {
    const std::vector<char> exact(text.begin(), text.end());  // a sanitizer sees the byte behind it
    std::span<const char> rest(exact);
    std::vector<std::int64_t> found;
    while (!rest.empty()) {
      const std::uint32_t point = detail::take_code_point(rest);
      found.push_back(point == detail::kNoCodePoint ? -1 : std::int64_t{point});
    }
    ASSERT_EQ(found, overlay_oracle::characters(text)) << testing::PrintToString(text);
  }
}

TEST(Overlays, OtherFormatsAreMadeOfThePixelsWithThem) {
  RandomOverlay over(77);
  const World world(&over.overlay);
  const Drawn expected =
      overlay_oracle::over(draw<kPlain>(world.without(), world.staged.camera, kPixels), over.overlay);
  constexpr Effects kEffects = kOver | effect::dithered_format;
  for (const bool dither : {false, true}) {
    for (const PixelFormat format :
         {PixelFormat::rgb565, PixelFormat::rgb565_swapped, PixelFormat::gray4, PixelFormat::mono, PixelFormat::rgb666,
          PixelFormat::rgb444, PixelFormat::xrgb8888}) {
      if (dither && !is_narrow(format)) continue;
      const View view = with_samples(kPixels, 1, format, dither);
      std::vector<std::uint16_t> all = expected.pixels;
      if (dither) dither_pixels(format, {0, 0, view.width, view.height}, all.data());
      std::vector<std::uint8_t> bytes(std::size_t{bytes_per_row(view.width, format)} * view.height);
      if (format == PixelFormat::rgb565 || format == PixelFormat::rgb565_swapped) {
        convert_pixels(format, view.width, view.height, all.data(), reinterpret_cast<std::byte*>(all.data()));
        std::memcpy(bytes.data(), all.data(), bytes.size());
      } else {
        convert_pixels(format, view.width, view.height, all.data(), reinterpret_cast<std::byte*>(bytes.data()));
      }
      for (const std::uint16_t rows : {std::uint16_t{5}, view.height}) {
        const PlanResult planned = plan(count(world.staged.scene), view, kEffects, {.strip_rows = rows});
        ASSERT_TRUE(planned.status);
        Renderer<kEffects> renderer;
        EXPECT_EQ(bytes_by(renderer, world.staged.scene, world.staged.camera, view, planned.plan), bytes)
            << static_cast<int>(format) << (dither ? " dithered, " : ", ") << rows << " rows";
      }
    }
  }
}

TEST(Overlays, LieOverTheMeanOfSamples) {
  RandomOverlay over(5);
  for (const int samples : {2, 4}) {
    for (const bool dither : {false, true}) {
      const View view = with_samples(kPixels, samples, PixelFormat::rgb565, dither);
      constexpr Effects kSampled = effect::supersampled | effect::dithered_colours;
      const World world(&over.overlay, view);
      const Drawn expected =
          overlay_oracle::over(draw<kPlain | kSampled>(world.without(), world.staged.camera, view), over.overlay);
      for (const std::uint16_t rows : {std::uint16_t{9}, view.height}) {
        EXPECT_EQ(draw<kOver | kSampled>(world.staged.scene, world.staged.camera, view, {.strip_rows = rows}),
                  expected);
      }
    }
  }
}

TEST(Overlays, LieOverBlendedEdges) {
  RandomOverlay over(6);
  scenes::Staged staged;
  stage(scenes::edges, staged, 3, 20, kPixels);
  constexpr Effects kEdges = effects_of(scenes::edges.scene, scenes::edges.camera);
  const Drawn expected = overlay_oracle::over(draw<kEdges>(staged.scene, staged.camera, kPixels), over.overlay);
  staged.scene.overlay = &over.overlay;
  for (const std::uint16_t rows : {std::uint16_t{6}, kPixels.height}) {
    EXPECT_EQ(draw<kEdges | effect::overlay>(staged.scene, staged.camera, kPixels, {.strip_rows = rows}), expected);
  }
}

TEST(Overlays, TextMayChangeFromFrameToFrame) {
  char buffer[12] = "frame 0";
  const Label label[] = {{.text = buffer, .x = 3, .y = 4}};
  const Overlay overlay{.images = {}, .fonts = {&kSmallFont, 1}, .sprites = {}, .labels = label};
  const World world(&overlay);
  const Drawn plain = draw<kPlain>(world.without(), world.staged.camera, kPixels);
  for (char digit = '0'; digit <= '9'; ++digit) {
    buffer[6] = digit;
    const Drawn drawn = draw<kOver>(world.staged.scene, world.staged.camera, kPixels, {.strip_rows = 8});
    EXPECT_EQ(drawn, overlay_oracle::over(plain, overlay));
    EXPECT_NE(drawn, plain);
  }
}

TEST(Overlays, OwnFontsAreValidAndHaveAscii) {
  for (const Font& font : {kSmallFont, kLargeFont}) {
    const Overlay overlay{.images = {}, .fonts = {&font, 1}, .sprites = {}, .labels = {}};
    EXPECT_TRUE(validate(overlay));
    ASSERT_EQ(font.glyphs.size(), 96U);
    for (std::size_t i = 0; i < 95; ++i) EXPECT_EQ(font.glyphs[i].code_point, 32 + i);
    EXPECT_EQ(font.glyphs[95].code_point, 0xFFFDU);
  }
}

TEST(Overlays, WhatIsWrongWithThemIsFound) {
  const RandomOverlay good(3);
  const auto status_of = [&good](const auto& change) {
    RandomOverlay bad = good;
    bad.fonts[2].glyphs = bad.glyphs[2];
    bad.overlay = {bad.images, bad.fonts, bad.sprites, bad.labels};
    change(bad);
    Scene scene = scenes::overlay.scene;
    scene.overlay = &bad.overlay;
    return validate(scene);
  };
  const auto wrong = [](OverlayPart part, std::uint32_t index) {
    return Status{.error = Error::overlay, .needed = index, .available = static_cast<std::uint32_t>(part)};
  };
  EXPECT_TRUE(status_of([](RandomOverlay&) {}));

  const Status image = wrong(OverlayPart::image, 5);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.images[5].width = 0; }), image);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.images[5].height = 0; }), image);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.images[5].width = 4097; }), image);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.images[5].width = 65535, o.images[5].height = 65535; }), image);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.images[5].coverage_bits = 2; }), image);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.images[5].colours = o.images[5].colours.subspan(1); }), image);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.images[5].coverage = o.images[5].coverage.subspan(1); }), image);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.images[5].coverage = {}, o.images[5].colours = {}; }), image);

  const Status font = wrong(OverlayPart::font, 2);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.fonts[2].coverage_bits = 0; }), font);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.fonts[2].line_height = 0; }), font);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.fonts[2].line_height = 1025; }), font);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.fonts[2].baseline = 1025; }), font);
  EXPECT_EQ(status_of([](RandomOverlay& o) { o.fonts[2].coverage = o.fonts[2].coverage.subspan(1); }), font);
  const auto glyph = [&](const auto& change) { return status_of([&](RandomOverlay& o) { change(o.glyphs[2][3]); }); };
  EXPECT_EQ(glyph([](Glyph& g) { g.code_point = 0x42; }), font) << "twice the same";
  EXPECT_EQ(glyph([](Glyph& g) { g.code_point = 0xFFFF; }), font) << "out of order";
  EXPECT_EQ(glyph([](Glyph& g) { g.offset = 0xFFFFFFFF, g.width = g.height = 1; }), font);
  EXPECT_EQ(glyph([](Glyph& g) { g.left = -1025; }), font);
  EXPECT_EQ(glyph([](Glyph& g) { g.left = 1025; }), font);
  EXPECT_EQ(glyph([](Glyph& g) { g.top = 1025; }), font);
  EXPECT_EQ(glyph([](Glyph& g) { g.advance = 1025; }), font);
  EXPECT_EQ(glyph([&](Glyph& g) { g.top = static_cast<std::int16_t>(2 * good.fonts[2].line_height + 1); }), font);
  EXPECT_EQ(glyph([](Glyph& g) { g.top = static_cast<std::int16_t>(-60); }), font);

  // Those may change between frames: begin_frame sees them, too.
  const auto begun_with = [&](const auto& change) {
    RandomOverlay bad = good;
    bad.overlay = {bad.images, bad.fonts, bad.sprites, bad.labels};
    change(bad);
    const World world(&bad.overlay);
    const Plan planned = plan(count(world.staged.scene), kPixels, kOver).plan;
    const Status status = begun(Renderer<kOver>(), world.staged.scene, world.staged.camera, kPixels, planned);
    EXPECT_EQ(validate(world.staged.scene), status);
    return status;
  };
  const Status sprite = wrong(OverlayPart::sprite, 4), label = wrong(OverlayPart::label, 1);
  EXPECT_EQ(begun_with([](RandomOverlay& o) { o.sprites[4].image = 8; }), sprite);
  EXPECT_EQ(begun_with([](RandomOverlay& o) { o.labels[1].font = 3; }), label);
  EXPECT_EQ(begun_with([](RandomOverlay& o) { o.labels[1].alignment = static_cast<Alignment>(3); }), label);
  const std::string long_text(65536, 'A');
  EXPECT_EQ(begun_with([&](RandomOverlay& o) { o.labels[1].text = chars(long_text); }), label);
  EXPECT_TRUE(begun_with([&](RandomOverlay& o) { o.labels[1].text = chars(long_text).subspan(1); }));
  EXPECT_NE(std::string_view(message(Error::overlay)).find("overlay"), std::string_view::npos);
}

/// The farthest places that pass the checks overflow nothing.
TEST(Overlays, TextMayBeAsLongAndLargeAsItIsAllowed) {
  const std::uint8_t coverage[] = {255};
  const Glyph glyphs[] = {{.code_point = 'A', .width = 8, .height = 1, .left = 1024, .top = 1024, .advance = 1024}};
  const Font fonts[] = {{.glyphs = glyphs, .coverage = coverage, .line_height = 1024, .baseline = 0}};
  std::string wide(65535, 'A'), high(65535, '\n');
  Label labels[] = {{.text = chars(wide), .x = -32768}, {.text = chars(high), .y = 32767}};
  for (const Alignment alignment : {Alignment::left, Alignment::centre, Alignment::right}) {
    for (Label& label : labels) label.alignment = alignment, label.background = {255, 0, 0, 255};
    const Overlay overlay{.images = {}, .fonts = fonts, .sprites = {}, .labels = labels};
    ASSERT_TRUE(validate(overlay));
    std::vector<std::uint16_t> pixels(8 * 6, 0);
    draw_overlay(overlay, {0, 0, 8, 6}, pixels.data());
    EXPECT_EQ((Drawn{8, 6, pixels}),
              overlay_oracle::over({8, 6, std::vector<std::uint16_t>(pixels.size(), 0)}, overlay));
  }
}

TEST(Overlays, WhatIsDrawnOverOtherPixelsHasNone) {
  const View view{80, 56};
  const World world(&scenes::kKnotOverlay, view);
  const Plan planned = plan(count(world.staged.scene), view, kOver, {.strip_rows = 8}).plan;
  std::vector<std::byte> arena = lent(planned.bytes());
  std::vector<std::uint16_t> pixels(std::size_t{80} * 56), depth(pixels.size());
  Renderer<kOver> renderer;
  ASSERT_TRUE(renderer.begin_frame(world.staged.scene, world.staged.camera, view, planned, arena));
  EXPECT_EQ(renderer.draw_over({0, 0, 80, 56}, pixels, depth).error, Error::overlay);
  const Scene without = world.without();
  ASSERT_TRUE(renderer.begin_frame(without, world.staged.camera, view, planned, arena));
  EXPECT_TRUE(renderer.draw_over({0, 0, 80, 56}, pixels, depth));
}

}  // namespace
}  // namespace effects_test
