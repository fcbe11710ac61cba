// The player draws what a renderer draws: in any memory that is enough, at any time, on any display.
#include "baked.hpp"
#include "zstrip/base/math.hpp"
#include "zstrip_hal/changed_tiles.hpp"

namespace zstrip::test {
namespace {

constexpr hal::DisplayFormat kFormats[] = {hal::DisplayFormat::rgb565,  hal::DisplayFormat::rgb565_swapped,
                                           hal::DisplayFormat::gray4,   hal::DisplayFormat::mono,
                                           hal::DisplayFormat::rgb666,  hal::DisplayFormat::rgb444,
                                           hal::DisplayFormat::xrgb8888};
constexpr std::size_t kMuch = 4 << 20;

/// The number of bytes that the player says are missing; 0 if it says something else.
std::size_t missing_bytes(Player& player) {
  const std::string words = player.error();
  return words.find(" bytes of memory are missing: ") == std::string::npos ? 0 : std::stoul(words);
}

/// The least memory in which a player opens and fits, found by giving it what it says is missing; -1 if that never
/// ends.
std::size_t least_memory(Blob& blob, const Screen& screen, const FitOptions& options = {}) {
  std::size_t size = 0;
  for (int tries = 0; tries < 8; ++tries) {
    Memory memory(size);
    Player player(memory.span(), drawn_with_any);
    if (player.open(blob.data(), blob.size()) && player.fit(screen.display, options)) return size;
    size += missing_bytes(player);
  }
  ADD_FAILURE() << "what is missing is not all";
  return kMuch;
}

// Sanitizers see one size.
TEST(Player, DrawsWhatARendererDraws) {
  for (const std::string scene : kScenes) {
    Blob blob = blob_of(scene);
    std::size_t format = 0;
    for (const auto& [width, height] : {std::pair{160, 120}, {101, 77}, {128, 64}}) {
      if (ZSTRIP_FEW_SAMPLES != 0 && width != 101) continue;
      Screen screen(static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height), kFormats[format++ % 7]);
      for (const std::size_t memory_size : {least_memory(blob, screen), kMuch}) {
        Memory memory(memory_size);
        Player player(memory.span(), drawn_with_any);
        ASSERT_TRUE(player.open(blob.data(), blob.size())) << scene << ": " << player.error();
        ASSERT_TRUE(player.fit(screen.display)) << scene << ": " << player.error();
        for (const std::uint32_t time : {0U, 500U, 1001U}) {
          player.seek(time);
          ASSERT_TRUE(player.draw(screen.display)) << scene << ": " << player.error();
          EXPECT_EQ(screen.pixels, drawn_directly(blob, screen, {.time = player.time()}))
              << scene << " at " << time << " in " << memory_size << " bytes";
        }
      }
    }
  }
}

TEST(Player, DrawsEveryFormat) {
  Blob blob = blob_of("room");
  for (const hal::DisplayFormat format : kFormats) {
    Screen screen(90, 60, format);
    Memory memory(least_memory(blob, screen) + 5000, 3);  // at an odd address
    Player player(memory.span(), drawn_with_any);
    ASSERT_TRUE(player.open(blob.data(), blob.size()) && player.fit(screen.display)) << player.error();
    ASSERT_TRUE(player.draw(screen.display)) << player.error();
    EXPECT_EQ(screen.pixels, drawn_directly(blob, screen));
  }
}

TEST(Player, DrawsWithThePipelineOfAScene) {
  Blob blob = blob_of("teapot_meshlets");
  Screen screen(160, 120, hal::DisplayFormat::rgb565);
  for (const std::uint8_t buffers : {std::uint8_t{1}, std::uint8_t{2}}) {
    Memory memory(60'000);
    Player player(memory.span(), drawn_with<kTeapot>);
    ASSERT_TRUE(player.open(blob.data(), blob.size())) << player.error();
    ASSERT_TRUE(player.fit(screen.display, {.strip_buffers = buffers})) << player.error();
    player.seek(300);
    ASSERT_TRUE(player.draw(screen.display)) << player.error();
    EXPECT_EQ(screen.pixels, drawn_directly(blob, screen, {.time = 300}));
  }
}

TEST(Player, TakesTheConstantsOfAHeader) {
  Blob blob = blob_of("teapot_meshlets");
  SceneBlob opened;
  Memory tables(1 << 16), memory(60'000);
  ASSERT_TRUE(open_scene_blob(blob.memory.span(), tables.span(), opened));
  Screen screen(100, 120, hal::DisplayFormat::rgb565);
  Player player(memory.span(), drawn_with_any);
  ASSERT_TRUE(player.open({opened.scene, opened.camera_for(2), opened.animation, opened.turn}, opened.view));
  ASSERT_TRUE(player.fit(screen.display)) << player.error();
  player.seek(77);
  ASSERT_TRUE(player.draw(screen.display)) << player.error();
  EXPECT_EQ(screen.pixels, drawn_directly(blob, screen, {.time = 77}));
}

TEST(Player, HasOneBufferOrTwo) {
  Blob blob = blob_of("teapot_meshlets");
  Screen screen(160, 120, hal::DisplayFormat::rgb565);
  for (int buffers = 0; buffers < 5; ++buffers) {
    Memory memory(30'000);
    Player player(memory.span(), drawn_with_any);
    ASSERT_TRUE(player.open(blob.data(), blob.size())) << player.error();
    const FitOptions options{.strip_buffers = static_cast<std::uint8_t>(buffers), .split_columns = buffers % 2 == 1};
    ASSERT_TRUE(player.fit(screen.display, options)) << player.error();
    ASSERT_TRUE(player.draw(screen.display)) << player.error();
    EXPECT_EQ(screen.pixels, drawn_directly(blob, screen)) << buffers;
  }
}

TEST(Player, HasTheRowsOfItsOptionsWhereTheyFit) {
  Blob blob = blob_of("teapot_meshlets");
  Screen screen(160, 120, hal::DisplayFormat::rgb565);
  const FitOptions options{.strip_rows = 40};
  const std::size_t least = least_memory(blob, screen);
  for (const auto& [memory_size, fits] : {std::pair{kMuch, true}, {least, false}}) {
    Memory memory(memory_size);
    Player player(memory.span(), drawn_with_any);
    ASSERT_TRUE(player.open(blob.data(), blob.size())) << player.error();
    ASSERT_TRUE(player.fit(screen.display, options)) << player.error();
    EXPECT_EQ(player.plan().strip_rows == 40, fits);
    ASSERT_TRUE(player.draw(screen.display)) << player.error();
    EXPECT_EQ(screen.pixels, drawn_directly(blob, screen));
  }
  EXPECT_EQ(least_memory(blob, screen, options), least);
  // More rows than the picture has are all of them.
  Memory memory(kMuch);
  Player player(memory.span(), drawn_with_any);
  ASSERT_TRUE(player.open(blob.data(), blob.size()) && player.fit(screen.display, {.strip_rows = 500}));
  EXPECT_EQ(player.plan().strips, 1);
}

TEST(Player, HandsOutStrips) {
  Blob blob = blob_of("teapot_meshlets");
  Screen screen(160, 120, hal::DisplayFormat::rgb565);
  Memory memory(least_memory(blob, screen) + 2000);
  Player player(memory.span(), drawn_with_any);
  ASSERT_TRUE(player.open(blob.data(), blob.size()) && player.fit(160, 120, PixelFormat::rgb565)) << player.error();
  EXPECT_GT(player.plan().strips, 1);
  std::vector<std::byte> picture;
  ASSERT_TRUE(player.draw_strips([&](const Rect& area, std::span<const std::byte> pixels) {
    EXPECT_EQ(area.left, 0);
    EXPECT_EQ(static_cast<std::size_t>(area.top) * 320, picture.size());
    picture.insert(picture.end(), pixels.begin(), pixels.end());
    return true;
  })) << player.error();
  EXPECT_EQ(picture, drawn_directly(blob, screen));
}

/// A panel whose bytes are eight rows.
struct Pages : hal::Framebuffer {
  static constexpr std::uint16_t kRowStep = 8;
  using Framebuffer::Framebuffer;
};

TEST(Player, StripsHaveWholeStepsOfRows) {
  Blob blob = blob_of("teapot_meshlets");
  std::vector<std::byte> pixels(128 * 64 / 8);
  Pages panel(pixels, {128, 64, hal::DisplayFormat::mono});
  int fitted = 0;
  for (std::size_t size = 6'000; size < 40'000; size += 997) {
    Memory memory(size);
    Player player(memory.span(), drawn_with_any);
    if (!player.open(blob.data(), blob.size()) || !player.fit(panel)) {
      EXPECT_GT(missing_bytes(player), 0U) << player.error();
      continue;
    }
    ++fitted;
    EXPECT_EQ(player.plan().strip_rows % 8, 0) << size;
    ASSERT_TRUE(player.draw(panel)) << player.error();
    EXPECT_EQ(pixels, drawn_directly(blob, Screen(128, 64, hal::DisplayFormat::mono)));
  }
  EXPECT_GT(fitted, 10);
}

TEST(Player, SaysToTheByteWhatIsMissing) {
  for (const std::string scene : kScenes) {
    Blob blob = blob_of(scene);
    const Screen screen(160, 120, hal::DisplayFormat::rgb444);
    for (const std::uint8_t buffers : {std::uint8_t{1}, std::uint8_t{2}}) {
      const std::size_t least = least_memory(blob, screen, {.strip_buffers = buffers});
      for (const std::size_t lacking : {1U, 40U, 2000U}) {
        if (lacking > least) continue;
        Memory memory(least - lacking);
        Player player(memory.span(), drawn_with_any);
        EXPECT_FALSE(player.open(blob.data(), blob.size()) && player.fit(screen.display, {.strip_buffers = buffers}))
            << scene << " lacks " << lacking;
        EXPECT_GT(missing_bytes(player), 0U) << player.error();
      }
    }
  }
}

/// A player of the teapot on 120x90 pixels.
class PlayerOfTeapot : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(player.open(blob.data(), blob.size()) && player.fit(screen.display)) << player.error();
  }
  /// What is drawn now, and with the camera that it was fitted with.
  const std::vector<std::byte>& drawn() {
    EXPECT_TRUE(player.draw(screen.display)) << player.error();
    return screen.pixels;
  }
  Camera fitted() {
    SceneBlob opened;
    EXPECT_TRUE(open_scene_blob(blob.memory.span(), tables.span(), opened));
    return scenes::fit_width(opened.camera_for(2), opened.view, player.view());
  }

  Blob blob = blob_of("teapot_meshlets");
  Screen screen{120, 90, hal::DisplayFormat::rgb565};
  Memory memory{100'000}, tables{1 << 16};
  Player player{memory.span(), drawn_with_any};
};

TEST_F(PlayerOfTeapot, OrbitsAboutTheYAxis) {
  const Camera at_rest = fitted();
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    player.orbit(static_cast<Angle>(16384 * quarter), 0);
    // The camera looks at the y axis, about which both turn.
    Camera turned = at_rest;
    for (std::uint32_t i = 0; i < quarter; ++i) {
      for (Vec3* axis : {&turned.right, &turned.up, &turned.back, &turned.eye}) *axis = {axis->z, axis->y, -axis->x};
    }
    const std::vector<std::byte> expected = drawn_directly(blob, screen, {.camera = turned});
    int differing = 0;
    const std::vector<std::byte>& seen = drawn();
    for (std::size_t i = 0; i < expected.size(); ++i) differing += seen[i] != expected[i] ? 1 : 0;
    EXPECT_LT(differing, 100) << quarter;  // of 21,600 bytes; the eye is rounded
  }
  player.orbit(0, 0);
  EXPECT_EQ(drawn(), drawn_directly(blob, screen));
}

TEST_F(PlayerOfTeapot, OrbitsAtTheSameDistance) {
  const auto lit = [this] {
    int count = 0;
    for (const std::byte byte : drawn()) count += byte != screen.pixels[0] ? 1 : 0;
    return count;
  };
  const int before = lit();
  for (Angle right = 0; right < 60'000; right = static_cast<Angle>(right + 7'001)) {
    for (const int up : {-9'000, -300, 0, 5, 4'000, 9'000, 30'000}) {
      player.orbit(right, static_cast<Angle>(up));
      EXPECT_GT(lit(), before / 3) << right << ", " << up;
      EXPECT_LT(lit(), before * 3) << right << ", " << up;
    }
  }
}

TEST_F(PlayerOfTeapot, ZoomsByTheFocalLength) {
  for (const std::uint16_t percent : std::initializer_list<std::uint16_t>{1, 50, 100, 133, 400}) {
    player.zoom(percent);
    Camera zoomed = fitted();
    zoomed.focal = static_cast<Fixed>(std::int64_t{zoomed.focal} * percent / 100);
    EXPECT_EQ(drawn(), drawn_directly(blob, screen, {.camera = zoomed})) << percent;
  }
  player.zoom(0);
  EXPECT_NE(drawn().size(), 0U);
}

TEST_F(PlayerOfTeapot, PlaysByTheClockOfTheCaller) {
  player.play(0xFFFFFF00);  // the first call is the beginning, whatever the time
  EXPECT_EQ(player.time(), 0U);
  player.play(0x100);  // the clock has begun again
  EXPECT_EQ(player.time(), 0x200U);
  player.hold(true);
  player.play(0x300);
  EXPECT_EQ(player.time(), 0x200U);
  player.hold(false);
  player.play(0x310);
  EXPECT_EQ(player.time(), 0x210U);
  EXPECT_EQ(drawn(), drawn_directly(blob, screen, {.time = 0x210}));
  player.play(0x310 + Player::kTurnTime);
  EXPECT_EQ(player.time(), 0x210U);
  player.seek(Player::kTurnTime + 5);
  EXPECT_EQ(player.time(), 5U);
}

TEST_F(PlayerOfTeapot, ShowsTextAndFramesPerSecond) {
  const Font fonts[] = {kSmallFont};
  const auto expect_text = [&](const std::string& text) {
    const Label labels[] = {{.text = text, .x = 2, .y = 2, .background = {0, 0, 0, 255}}};
    const Overlay overlay{.fonts = fonts, .labels = labels};
    EXPECT_EQ(drawn(), drawn_directly(blob, screen, {.overlay = &overlay})) << text;
  };
  player.hold(true);
  player.show_text("teapot");
  expect_text("teapot");
  player.show_text("a text of more than twenty-four bytes");
  expect_text("a text of more than twen");
  player.show_text("now ", true);
  player.play(5'000);
  expect_text("now - fps");
  for (std::uint32_t frame = 1; frame < 20; ++frame) {
    player.play(5'000 + 50 * frame);
    drawn();
  }
  player.play(6'000);
  expect_text("now 20 fps");
  player.play(8'000);  // one frame in two seconds, and half a frame is rounded up
  expect_text("now 1 fps");
  player.show_text("");
  EXPECT_EQ(drawn(), drawn_directly(blob, screen));
}

TEST_F(PlayerOfTeapot, PicksInTheFrameThatItDrewLast) {
  const auto picked = [this](std::uint16_t x, std::uint16_t y) {
    Picked found;
    EXPECT_TRUE(player.pick(pick_with_any, x, y, found)) << player.error();
    return found;
  };
  const Picked middle = picked(60, 45);
  EXPECT_EQ(middle.shown, Shown::instance);
  EXPECT_EQ(picked(0, 0).shown, Shown::background);
  player.orbit(16384, 0);
  EXPECT_EQ(picked(60, 45), middle);
  drawn();
  const Picked aside = picked(60, 45);
  EXPECT_EQ(aside.shown, Shown::instance);
  EXPECT_NE(aside.triangle, middle.triangle);
  player.zoom(1);
  drawn();
  EXPECT_EQ(picked(30, 20).shown, Shown::background);
  player.show_text("MMMM");
  drawn();
  EXPECT_EQ(picked(3, 6), (Picked{.shown = Shown::label, .index = 0}));
  Picked outside;
  EXPECT_FALSE(player.pick(pick_with_any, 120, 45, outside));
  EXPECT_EQ(std::string(player.error()), "the pixel is outside of the picture");
  EXPECT_EQ(picked(60, 89).shown, Shown::background);
  EXPECT_EQ(std::string(player.error()), "");
}

TEST(Player, PicksNothingBeforeItIsFitted) {
  Memory memory(20'000);
  Player player(memory.span(), drawn_with_any);
  Picked picked{.index = 3};
  EXPECT_FALSE(player.pick(pick_with_any, 0, 0, picked));
  EXPECT_EQ(std::string(player.error()), "no scene is open: open() comes first");
  EXPECT_EQ(picked, Picked{});
  Blob blob = blob_of("csg");
  Memory enough(kMuch);
  Player products(enough.span(), drawn_with_any);
  ASSERT_TRUE(products.open(blob.data(), blob.size()));
  EXPECT_FALSE(products.pick(pick_with_any, 0, 0, picked));
  ASSERT_TRUE(products.fit(80, 60, PixelFormat::rgb565));
  EXPECT_FALSE(products.pick(pick_with_any, 0, 0, picked));
  EXPECT_EQ(std::string(products.error()).find("the pixel cannot be picked: "), 0U);
}

TEST(Player, TextIsBesideTheOverlayOfTheScene) {
  Blob blob = blob_of("overlay");
  Screen screen(160, 120, hal::DisplayFormat::rgb565);
  Memory memory(kMuch), tables(kMuch);
  Player player(memory.span(), drawn_with_any);
  ASSERT_TRUE(player.open(blob.data(), blob.size()) && player.fit(screen.display)) << player.error();
  player.show_text("abc", false, kLargeFont);
  ASSERT_TRUE(player.draw(screen.display)) << player.error();

  SceneBlob opened;
  ASSERT_TRUE(open_scene_blob(blob.memory.span(), tables.span(), opened));
  Overlay overlay = *opened.scene.overlay;
  std::vector<Font> fonts(overlay.fonts.begin(), overlay.fonts.end());
  std::vector<Label> labels(overlay.labels.begin(), overlay.labels.end());
  labels.push_back({.text = std::span("abc"),
                    .x = 2,
                    .y = 2,
                    .font = static_cast<std::uint16_t>(fonts.size()),
                    .background = {0, 0, 0, 255}});
  fonts.push_back(kLargeFont);
  overlay.fonts = fonts;
  overlay.labels = labels;
  EXPECT_EQ(screen.pixels, drawn_directly(blob, screen, {.overlay = &overlay}));
}

using Changes = hal::ChangedTiles<hal::Framebuffer, 100>;

/// Versions of fingerprints began with 0 in each player, so that strips of the scene before were left out.
TEST(PlayerChangedTiles, AnotherPlayerDrawsOtherBytesAtTheAddressOfABlob) {
  Blob blob = blob_of("teapot_meshlets");
  Screen screen(120, 90, hal::DisplayFormat::rgb565);
  Changes changes(screen.display);
  Memory memory(100'000);
  for (const bool other : {false, true}) {
    if (other) {
      SceneBlob opened;
      Memory tables(1 << 16);
      ASSERT_TRUE(open_scene_blob(blob.memory.span(), tables.span(), opened));
      const std::span<const Position> positions = opened.scene.meshes[0].positions;
      for (const Position& each : positions) const_cast<Position&>(each).x = static_cast<std::int16_t>(each.x / 2);
      const std::uint32_t sum = crc32(blob.memory.span().subspan(12));
      for (std::size_t i = 0; i < 4; ++i) blob.memory.span()[8 + i] = static_cast<std::byte>(sum >> 8 * i);
    }
    Player player(memory.span(), drawn_with_any);
    ASSERT_TRUE(player.open(blob.data(), blob.size()) && player.fit(changes, {.strip_rows = 16})) << player.error();
    ASSERT_TRUE(player.draw(changes)) << player.error();
    EXPECT_EQ(screen.pixels, drawn_directly(blob, screen)) << other;
  }
}

/// The same with constants, of which a player is made for each frame; or there are two at a time.
TEST(PlayerChangedTiles, AnotherPlayerDrawsConstantsThatChanged) {
  Position corners[]{{-32767, -32767, 0}, {32767, -32767, 0}, {0, 32767, 0}};
  constexpr Triangle kTriangles[]{{0, 1, 2}};
  const Mesh mesh{
      .positions = corners, .normals = {}, .colours = {}, .texcoords = {}, .triangles = kTriangles, .meshlets = {}};
  const Material material{.colour = {255, 0, 0, 255}, .lit = false};
  const Instance instance{};
  const Scene scene{
      .meshes = {&mesh, 1}, .materials = {&material, 1}, .textures = {}, .instances = {&instance, 1}, .lights = {}};
  const View view{120, 90};
  Screen screen(120, 90, hal::DisplayFormat::rgb565), whole(120, 90, hal::DisplayFormat::rgb565);
  Changes changes(screen.display);
  Memory memories[]{Memory(100'000), Memory(100'000)};
  const auto move = [&] { corners[2].x = static_cast<std::int16_t>(corners[2].x + 3'000); };
  const auto draw = [&](Player& player, auto& display) { ASSERT_TRUE(player.draw(display)) << player.error(); };
  const auto open = [&](Player& player) {
    ASSERT_TRUE(player.open({scene, Camera{}, {}, {}}, view) && player.fit(changes, {.strip_rows = 16}));
  };
  for (int frame = 0; frame < 3; ++frame, move()) {
    Player player(memories[0].span(), drawn_with_any);
    open(player);
    draw(player, changes);
    draw(player, whole.display);
    EXPECT_EQ(screen.pixels, whole.pixels) << frame;
  }
  Player one(memories[0].span(), drawn_with_any), other(memories[1].span(), drawn_with_any);
  open(one), open(other);
  for (int frame = 0; frame < 4; ++frame) {
    for (Player* player : {&one, &other}) {
      move();
      draw(*player, changes);
    }
    draw(one, whole.display), draw(other, whole.display);
    EXPECT_EQ(screen.pixels, whole.pixels) << frame;
  }
}

TEST_F(PlayerOfTeapot, OpensAndFitsAgain) {
  Blob other = blob_of("robot");
  Screen smaller(60, 80, hal::DisplayFormat::rgb565_swapped);
  Memory larger(kMuch);
  Player again(larger.span(), drawn_with_any);
  for (Blob* each : {&blob, &other, &blob}) {
    ASSERT_TRUE(again.open(each->data(), each->size())) << again.error();
    for (Screen* display : {&screen, &smaller, &screen}) {
      ASSERT_TRUE(again.fit(display->display)) << again.error();
      ASSERT_TRUE(again.draw(display->display)) << again.error();
      EXPECT_EQ(display->pixels, drawn_directly(*each, *display));
    }
  }
}

}  // namespace
}  // namespace zstrip::test
