// Parts of a frame by the player: strips in any order, rectangles, what was drawn, and what changed.
#include "baked.hpp"
#include "zstrip_player/c_pipeline.hpp"

namespace zstrip::test {
namespace {

constexpr std::uint16_t kWidth = 120, kHeight = 90;
constexpr Colour kBlue{0, 0, 248, 255}, kYellow{248, 252, 0, 255};

/// A player with its memory, fitted.
struct Fitted {
  Blob blob;
  Memory memory;
  Player player;
  Fitted(const std::string& scene, PixelFormat format, const FitOptions& options, std::size_t bytes = 400'000)
      : blob(blob_of(scene)), memory(bytes), player(memory.span(), drawn_with_any) {
    EXPECT_TRUE(player.open(blob.data(), blob.size())) << player.error();
    EXPECT_TRUE(player.fit(kWidth, kHeight, format, options)) << player.error();
  }
};

/// The whole picture at the player's time, by draw_strips.
std::vector<std::byte> picture_of(Player& player) {
  const std::size_t row = bytes_per_row(kWidth, player.view().format);
  std::vector<std::byte> picture(row * kHeight);
  EXPECT_TRUE(player.draw_strips([&](const Rect& area, std::span<const std::byte> pixels) {
    std::ranges::copy(pixels, picture.begin() + static_cast<std::ptrdiff_t>(row) * area.top);
    return true;
  })) << player.error();
  return picture;
}

/// True where something was drawn: where the picture does not show two backgrounds as they are.
std::vector<bool> drawn_over(Player& player, PixelFormat format) {
  const std::size_t size = bytes_per_row(1, format);
  std::vector<bool> drawn(std::size_t{kWidth} * kHeight, false);
  for (const Colour& colour : {kBlue, kYellow}) {
    player.background(colour);
    const std::vector<std::byte> picture = picture_of(player);
    // 248 and 252 are the colours' bits in each format.
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      std::uint32_t seen = 0;
      for (std::size_t byte = 0; byte < size; ++byte) {
        seen |= std::to_integer<std::uint32_t>(picture[i * size + byte]) << 8 * byte;
      }
      const bool blue = colour.b != 0;
      std::uint32_t plain = blue ? 0x001F : 0xFFE0;
      if (format == PixelFormat::rgb565_swapped) plain = blue ? 0x1F00 : 0xE0FF;
      if (format == PixelFormat::xrgb8888) seen &= 0xFFFFFF, plain = blue ? 0x0000FF : 0xFFFF00;
      if (seen != plain) drawn[i] = true;
    }
  }
  return drawn;
}

TEST(PlayerAreas, StripsInAnyOrderAreThoseOfThePicture) {
  for (const char* scene : {"teapot_meshlets", "robot"}) {
    Fitted shown(scene, PixelFormat::rgb565, {.strip_rows = 7});
    Player& player = shown.player;
    const std::vector<std::byte> picture = picture_of(player);
    ASSERT_GT(player.plan().strips, 5);
    ASSERT_TRUE(player.begin());
    for (const std::uint16_t strip : std::initializer_list<std::uint16_t>{3, 0, 3, 3, 5, 1}) {
      DrawnStrip drawn;
      ASSERT_TRUE(player.draw_strip(strip, drawn)) << player.error();
      EXPECT_TRUE(drawn.mask.empty());
      EXPECT_TRUE(std::ranges::equal(
          drawn.pixels,
          std::span(picture).subspan(2U * kWidth * static_cast<unsigned>(drawn.area.top), drawn.pixels.size())));
    }
    DrawnStrip none;
    EXPECT_FALSE(player.draw_strip(player.plan().strips, none));
    EXPECT_TRUE(std::string(player.error()).starts_with("a strip cannot be drawn: ")) << player.error();
  }
}

/// A strip that was kept would show the frame before.
TEST(PlayerAreas, AKeptStripIsDrawnAgainInTheNextFrame) {
  Fitted shown("robot", PixelFormat::rgb565, {.strip_rows = 90});
  Player& player = shown.player;
  DrawnStrip drawn;
  player.seek(0);
  ASSERT_TRUE(player.begin() && player.draw_strip(0, drawn));
  const std::vector<std::byte> before(drawn.pixels.begin(), drawn.pixels.end());
  player.seek(400);
  ASSERT_TRUE(player.begin() && player.draw_strip(0, drawn));
  const std::vector<std::byte> after(drawn.pixels.begin(), drawn.pixels.end());
  EXPECT_NE(before, after);
  EXPECT_EQ(after, picture_of(player));
}

TEST(PlayerAreas, TheMaskIsWhatHidesEveryBackground) {
  for (const char* scene : kScenes) {
    for (const PixelFormat format : {PixelFormat::rgb565, PixelFormat::rgb565_swapped, PixelFormat::xrgb8888}) {
      Fitted shown(scene, format, {.strip_rows = 16, .masked = true});
      Player& player = shown.player;
      const std::vector<bool> wanted = drawn_over(player, format);
      // The second background has colours of the scene: only depth tells them.
      for (const Colour& colour : {kBlue, Colour{255, 255, 255, 255}}) {
        player.background(colour);
        ASSERT_TRUE(player.begin()) << player.error();
        std::size_t wrong = 0, drawn_pixels = 0;
        for (std::uint16_t strip = 0; strip < player.plan().strips; ++strip) {
          DrawnStrip drawn;
          ASSERT_TRUE(player.draw_strip(strip, drawn)) << player.error();
          ASSERT_EQ(reinterpret_cast<const std::byte*>(drawn.mask.data()), drawn.pixels.data() + drawn.pixels.size());
          const std::size_t first = std::size_t{kWidth} * static_cast<std::size_t>(drawn.area.top);
          for (std::size_t i = 0; i < drawn.mask.size(); ++i) {
            ASSERT_TRUE(drawn.mask[i] == 0 || drawn.mask[i] == 255);
            if ((drawn.mask[i] != 0) != wanted[first + i]) ++wrong;
            if (drawn.mask[i] != 0) ++drawn_pixels;
          }
        }
        // White labels on white are not in the mask.
        const bool labels = std::string(scene) == "overlay" && colour.r != 0;
        if (!labels) {
          EXPECT_EQ(wrong, 0U) << scene << ' ' << static_cast<int>(format) << ' ' << int{colour.r};
        }
        EXPECT_GT(drawn_pixels, 100U) << scene;
      }
    }
  }
}

/// Shadows leave depth where nothing was drawn, so that all of the scene's rectangle was in the mask.
TEST(PlayerAreas, TheMaskOfASceneWithShadowsHasNoBackground) {
  Fitted shown("shadows", PixelFormat::rgb565, {.strip_rows = 16, .masked = true});
  Player& player = shown.player;
  const std::vector<bool> wanted = drawn_over(player, PixelFormat::rgb565);
  player.background(kBlue);
  std::vector<std::byte> pixels(2U * kWidth * kHeight);
  std::vector<std::uint8_t> mask(wanted.size());
  ASSERT_TRUE(player.begin() && player.draw_area({0, 0, kWidth, kHeight}, pixels, 2U * kWidth, mask, kWidth));
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) wrong += (mask[i] != 0) != wanted[i] ? 1U : 0U;
  EXPECT_EQ(wrong, 0U);
  EXPECT_NE(std::ranges::count(mask, std::uint8_t{255}), 0);
}

TEST(PlayerAreas, AnyRectangleHasThePicturesPixelsAndMask) {
  for (const std::size_t bytes : {24'000U, 400'000U}) {
    Fitted shown("teapot_meshlets", PixelFormat::rgb565, {.masked = true}, bytes);
    Player& player = shown.player;
    const std::vector<std::byte> picture = picture_of(player);
    std::vector<std::uint8_t> whole(std::size_t{kWidth} * kHeight);
    std::vector<std::byte> all(picture.size());
    ASSERT_TRUE(player.begin() && player.draw_area({0, 0, kWidth, kHeight}, all, 2 * kWidth, whole, kWidth))
        << player.error();
    EXPECT_EQ(all, picture);
    for (const Rect& area : {Rect{10, 20, 60, 50}, Rect{0, 89, 120, 90}, Rect{119, 0, 120, 90}, Rect{33, 44, 34, 45}}) {
      const auto width = static_cast<std::size_t>(area.width()), height = static_cast<std::size_t>(area.height());
      const std::size_t stride = 2 * width + 3, mask_stride = width + 5;
      std::vector<std::byte> pixels(stride * (height - 1) + 2 * width, std::byte{0x5A});
      std::vector<std::uint8_t> mask(mask_stride * (height - 1) + width, 0x5A);
      ASSERT_TRUE(player.draw_area(area, pixels, stride, mask, mask_stride)) << player.error();
      for (std::size_t y = 0; y < height; ++y) {
        const std::size_t place =
            (static_cast<std::size_t>(area.top) + y) * kWidth + static_cast<std::size_t>(area.left);
        EXPECT_TRUE(std::ranges::equal(std::span(pixels).subspan(stride * y, 2 * width),
                                       std::span(picture).subspan(2 * place, 2 * width)));
        EXPECT_TRUE(std::ranges::equal(std::span(mask).subspan(mask_stride * y, width),
                                       std::span(whole).subspan(place, width)));
        if (y + 1 == height) break;
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(pixels[stride * y + 2 * width + i], std::byte{0x5A});
        for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(mask[mask_stride * y + width + i], 0x5A);
      }
    }
  }
}

TEST(PlayerAreas, SaysWhatIsWrongWithARectangle) {
  Fitted shown("teapot_meshlets", PixelFormat::rgb565, {});
  Player& player = shown.player;
  std::vector<std::byte> pixels(1000);
  std::vector<std::uint8_t> mask(100);
  const auto words = [&](const Rect& area, std::size_t stride, std::span<std::uint8_t> masked = {}) {
    return std::string(player.draw_area(area, pixels, stride, masked, 10) ? "" : player.error());
  };
  EXPECT_EQ(words({0, 0, 10, 10}, 20), "");
  EXPECT_EQ(words({0, 0, 0, 10}, 20), "the area is empty, or not within the picture");
  EXPECT_EQ(words({115, 0, 125, 10}, 20), "the area is empty, or not within the picture");
  EXPECT_EQ(words({0, 0, 10, 10}, 19), "the area's memory or stride has 19 bytes, and needs 20");
  EXPECT_EQ(words({0, 0, 10, 51}, 20), "the area's memory or stride has 1000 bytes, and needs 1020");
  EXPECT_EQ(words({0, 0, 10, 10}, 20, mask), "there is no mask: it was not asked for when the picture was fitted");
  ASSERT_TRUE(player.fit(kWidth, kHeight, PixelFormat::rgb565, {.masked = true}));
  EXPECT_EQ(words({0, 0, 10, 10}, 20, mask), "");
  EXPECT_EQ(words({0, 0, 11, 10}, 22, mask), "the area's memory or stride has 10 bytes, and needs 11");
  EXPECT_EQ(words({0, 0, 10, 11}, 20, mask), "the area's memory or stride has 100 bytes, and needs 110");
  EXPECT_FALSE(player.fit(kWidth, kHeight, PixelFormat::mono, {.masked = true}));
  EXPECT_STREQ(player.error(), "a mask needs a format with a byte or more for each pixel");
}

/// The planner does not know the mask: with every amount of memory it fits, or the words say how much is missing.
TEST(PlayerAreas, TheMaskFitsIntoAnyMemoryThatIsEnough) {
  Blob blob = blob_of("teapot_meshlets");
  std::size_t enough = 0;
  for (std::size_t bytes = 2000; bytes < 60'000; bytes += 500) {
    Memory memory(bytes);
    Player player(memory.span(), drawn_with_any);
    const bool fits =
        player.open(blob.data(), blob.size()) && player.fit(kWidth, kHeight, PixelFormat::rgb565, {.masked = true});
    EXPECT_TRUE(fits || enough == 0) << bytes;
    if (!fits) {
      EXPECT_NE(std::string(player.error()).find(" bytes of memory are missing: "), std::string::npos)
          << player.error();
      continue;
    }
    if (enough == 0) enough = bytes;
    DrawnStrip drawn;
    for (std::uint16_t strip = 0; strip < player.plan().strips; ++strip) {
      ASSERT_TRUE(player.draw_strip(strip, drawn));
      ASSERT_LE(reinterpret_cast<const std::byte*>(drawn.mask.data() + drawn.mask.size()),
                memory.span().data() + bytes);
    }
  }
  EXPECT_GT(enough, 0U);
}

TEST(PlayerChanges, NothingOutsideOfTheRectangleDiffers) {
  for (const char* scene : kScenes) {
    for (const bool tracks : {false, true}) {
      Fitted shown(scene, PixelFormat::rgb565, {.tracks_changes = tracks});
      Player& player = shown.player;
      std::vector<std::byte> before = picture_of(player);
      EXPECT_EQ(player.changed(), (Rect{0, 0, kWidth, kHeight}));
      EXPECT_TRUE(player.changed().empty());
      const auto step = [&](const char* what) {
        const std::vector<std::byte> after = picture_of(player);
        const Rect changed = player.changed();
        EXPECT_EQ(changed, changed.cut_to({0, 0, kWidth, kHeight}));
        std::size_t outside = 0;
        for (std::int32_t y = 0; y < kHeight; ++y) {
          for (std::int32_t x = 0; x < kWidth; ++x) {
            const auto i = static_cast<std::size_t>(2 * (y * kWidth + x));
            const bool same = before[i] == after[i] && before[i + 1] == after[i + 1];
            if (!same && !changed.touches({x, y, x + 1, y + 1})) ++outside;
          }
        }
        EXPECT_EQ(outside, 0U) << scene << ' ' << tracks << ' ' << what;
        before = after;
      };
      for (std::uint32_t time = 0; time < 2000; time += ZSTRIP_FEW_SAMPLES != 0 ? 520 : 130) {
        player.seek(time);
        step("moves");
      }
      player.orbit(900, 500);
      step("orbits");
      player.zoom(140);
      step("zooms");
      player.background(kYellow);
      step("has another background");
      player.show_text("changed");
      step("has a text");
      player.show_text("changed", false, kLargeFont);
      step("has another font");
      step("stands still");
      EXPECT_TRUE(player.begin() && player.changed().empty()) << scene;
    }
  }
}

/// The label pointed at the text itself, so that strips of one frame had different texts.
TEST(PlayerAreas, ATextThatIsSetDuringAFrameIsInTheNextOne) {
  Fitted shown("teapot_meshlets", PixelFormat::rgb565, {.strip_rows = 8});
  Player& player = shown.player;
  player.show_text("first");
  const std::vector<std::byte> expected = picture_of(player);
  ASSERT_TRUE(player.begin());
  (void)player.changed();
  player.show_text("second", true);
  player.play(0);
  std::vector<std::byte> seen(expected.size());
  ASSERT_TRUE(player.draw_area({0, 0, kWidth, kHeight}, seen, 2U * kWidth)) << player.error();
  EXPECT_EQ(seen, expected);
  EXPECT_TRUE(player.changed().empty()) << "of the same frame";
  ASSERT_TRUE(player.begin());
  EXPECT_FALSE(player.changed().empty());
}

/// The frame before was drawn with parts of the one that failed, and changed() read a font that was not there.
TEST(PlayerAreas, AfterAFaultOfBeginThereIsNoFrame) {
  Blob blob = blob_of("teapot_meshlets");
  Memory memory(400'000);
  Player player(memory.span(), [](Effects called_for) -> DrawnWith { return {called_for, pipeline_for(called_for)}; });
  ASSERT_TRUE(player.open(blob.data(), blob.size()) && player.fit(kWidth, kHeight, PixelFormat::rgb565));
  EXPECT_FALSE(player.changed().empty());
  player.show_text("no overlay");
  EXPECT_FALSE(player.begin());
  DrawnStrip drawn;
  EXPECT_FALSE(player.draw_strip(0, drawn));
  EXPECT_STREQ(player.error(), "a strip cannot be drawn: draw_strip needs a successful begin_frame");
  Picked picked;
  EXPECT_FALSE(player.pick(pick_with_any, 0, 0, picked));
  EXPECT_TRUE(player.changed().empty());
  player.show_text(nullptr);
  EXPECT_TRUE(player.begin() && player.draw_strip(0, drawn)) << player.error();
}

/// A fan and a robot move in a room.
TEST(PlayerChanges, ARectangleOfInstancesIsSmallerThanThatOfTheScene) {
  std::size_t pixels[2]{};
  for (const bool tracks : {false, true}) {
    Fitted shown("home", PixelFormat::rgb565, {.tracks_changes = tracks});
    Player& player = shown.player;
    std::vector<std::byte> before = picture_of(player);
    EXPECT_FALSE(player.changed().empty());
    for (std::uint32_t time = 100; time < 1000; time += 100) {
      player.seek(time);
      const std::vector<std::byte> after = picture_of(player);
      const Rect changed = player.changed();
      pixels[tracks ? 1 : 0] += static_cast<std::size_t>(changed.width()) * static_cast<std::size_t>(changed.height());
      for (std::int32_t y = 0; y < kHeight; ++y) {
        for (std::int32_t x = 0; x < kWidth; ++x) {
          if (changed.touches({x, y, x + 1, y + 1})) continue;
          const auto i = static_cast<std::size_t>(2 * (y * kWidth + x));
          ASSERT_TRUE(before[i] == after[i] && before[i + 1] == after[i + 1]) << x << ' ' << y << ' ' << time;
        }
      }
      before = after;
    }
  }
  EXPECT_LT(pixels[1] * 2, pixels[0]);
}

TEST(CPlayerAreas, AreThoseOfThePlayer) {
  constexpr zstrip_pipeline kPipeline{drawn_with_any};
  Fitted shown("teapot_meshlets", PixelFormat::rgb565, {.strip_rows = 16, .masked = true});
  Player& wanted = shown.player;
  wanted.seek(700);
  wanted.background({0x12, 0x34, 0x56, 255});
  Blob blob = blob_of("teapot_meshlets");
  Memory memory(400'000);
  zstrip_player* const player = zstrip_player_in(memory.span().data(), memory.span().size(), &kPipeline);
  const zstrip_fit_options options{16, 1, 1, 1};
  ASSERT_EQ(zstrip_player_open(player, blob.data(), blob.size()), 1);
  ASSERT_EQ(zstrip_player_fit_with(player, kWidth, kHeight, ZSTRIP_RGB565, &options), 1) << zstrip_player_error(player);
  zstrip_player_seek(player, 700);
  zstrip_player_background(player, 0x123456);
  EXPECT_EQ(zstrip_player_period(player), Player::kTurnTime);
  EXPECT_EQ(zstrip_player_period(nullptr), 1U);
  ASSERT_EQ(zstrip_player_begin(player), 1);
  zstrip_area changed;
  zstrip_player_changed(player, &changed);
  EXPECT_EQ(changed.width, kWidth);
  zstrip_player_changed(player, &changed);
  EXPECT_EQ(changed.width, 0);
  ASSERT_TRUE(wanted.begin());
  for (const std::uint16_t y : std::initializer_list<std::uint16_t>{0, 40, 47, 48, 89}) {
    zstrip_strip strip;
    DrawnStrip drawn;
    ASSERT_EQ(zstrip_player_strip(player, y, &strip), 1) << zstrip_player_error(player);
    ASSERT_TRUE(wanted.draw_strip(static_cast<std::uint16_t>(y / 16), drawn));
    EXPECT_EQ(strip.top, drawn.area.top);
    EXPECT_TRUE(std::ranges::equal(std::span(static_cast<const std::byte*>(strip.pixels), strip.bytes), drawn.pixels));
    EXPECT_TRUE(std::ranges::equal(std::span(strip.mask, drawn.mask.size()), drawn.mask));
  }
  zstrip_strip strip;
  EXPECT_EQ(zstrip_player_strip(player, kHeight + 16, &strip), 0);
  EXPECT_EQ(zstrip_player_strip(player, kHeight, &strip), 0)
      << "below the picture, but not below the last strip's rows";
  EXPECT_EQ(zstrip_player_strip(player, kHeight - 1, &strip), 1);
  EXPECT_EQ(zstrip_player_strip(player, 0, nullptr), 0);
  std::vector<std::byte> pixels(20 * 30 * 2), right(20 * 30 * 2);
  std::vector<std::uint8_t> mask(20 * 30), right_mask(20 * 30);
  const zstrip_area area{50, 33, 20, 30};
  EXPECT_EQ(zstrip_player_draw_area(player, &area, pixels.data(), pixels.size(), 40, mask.data(), 20), 1);
  ASSERT_TRUE(wanted.draw_area({50, 33, 70, 63}, right, 40, right_mask, 20));
  EXPECT_EQ(pixels, right);
  EXPECT_EQ(mask, right_mask);
  EXPECT_EQ(zstrip_player_draw_area(player, nullptr, pixels.data(), pixels.size(), 40, nullptr, 0), 0);
  EXPECT_EQ(zstrip_player_draw_area(player, &area, nullptr, 0, 40, nullptr, 0), 0);
  EXPECT_STREQ(zstrip_player_error(player), "the area is empty, or not within the picture");
  EXPECT_EQ(zstrip_player_begin(nullptr), 0);
  EXPECT_EQ(zstrip_player_strip(nullptr, 0, &strip), 0);
  EXPECT_EQ(zstrip_player_draw_area(nullptr, &area, pixels.data(), pixels.size(), 40, nullptr, 0), 0);
  EXPECT_EQ(zstrip_player_fit_with(nullptr, 1, 1, ZSTRIP_RGB565, &options), 0);
  zstrip_player_background(player, ZSTRIP_BAKED_BACKGROUND);
  zstrip_player_background(nullptr, 0);
  zstrip_player_changed(nullptr, &changed);
  EXPECT_EQ(changed.width, 0);
  zstrip_player_changed(player, nullptr);
}

}  // namespace
}  // namespace zstrip::test
