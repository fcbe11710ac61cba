// What a player says is wrong; and bytes that are no scene harm nothing.
#include "baked.hpp"

namespace zstrip::test {
namespace {

struct Lit {
  Blob blob = blob_of("teapot_meshlets");
  Screen screen{120, 90, hal::DisplayFormat::rgb565};
  Memory memory{100'000};
  Player player{memory.span(), drawn_with_any};
  bool open_and_fit() { return player.open(blob.data(), blob.size()) && player.fit(screen.display); }
};

TEST(PlayerErrors, NothingIsSaidWhereNothingIsWrong) {
  Lit lit;
  EXPECT_STREQ(lit.player.error(), "");
  EXPECT_FALSE(lit.player.open(lit.blob.data(), 8));
  ASSERT_TRUE(lit.open_and_fit());
  EXPECT_STREQ(lit.player.error(), "");
  ASSERT_TRUE(lit.player.draw(lit.screen.display));
  EXPECT_STREQ(lit.player.error(), "");
}

TEST(PlayerErrors, CallsHaveAnOrder) {
  Lit lit;
  EXPECT_FALSE(lit.player.fit(lit.screen.display));
  EXPECT_STREQ(lit.player.error(), "no scene is open: open() comes first");
  EXPECT_FALSE(lit.player.draw(lit.screen.display));
  EXPECT_STREQ(lit.player.error(), "no scene is open: open() comes first");
  ASSERT_TRUE(lit.player.open(lit.blob.data(), lit.blob.size()));
  EXPECT_FALSE(lit.player.draw(lit.screen.display));
  EXPECT_STREQ(lit.player.error(), "no display is fitted: fit() comes before draw()");
  ASSERT_TRUE(lit.open_and_fit());
  // What cannot be opened closes what was open.
  EXPECT_FALSE(lit.player.open(lit.blob.data(), 0));
  EXPECT_FALSE(lit.player.draw(lit.screen.display));
  EXPECT_STREQ(lit.player.error(), "no scene is open: open() comes first");
}

TEST(PlayerErrors, OfBytesThatAreNoScene) {
  Lit lit;
  const auto said = [&lit](std::size_t beyond, std::size_t size) {
    const std::byte* bytes = lit.blob.memory.span().data() + beyond;
    EXPECT_FALSE(lit.player.open(bytes, size));
    return std::string(lit.player.error());
  };
  const std::size_t size = lit.blob.size();
  EXPECT_EQ(said(0, 100), "these bytes are no whole scene: byte 100 is wrong; bake it again");
  EXPECT_EQ(said(1, size - 1), "the scene does not lie at a multiple of 4: alignas(4)");
  lit.blob.memory.span()[2] = std::byte{4};
  EXPECT_EQ(said(0, size), "the scene is of version 4, and version 6 is read: bake it again");
}

TEST(PlayerErrors, OfMemory) {
  Lit lit;
  const auto said = [&lit](std::size_t size) {
    Memory memory(size);
    Player player(memory.span(), drawn_with_any);
    EXPECT_FALSE(player.open(lit.blob.data(), lit.blob.size()) && player.fit(lit.screen.display));
    return std::string(player.error());
  };
  const std::size_t tables = sizeof(Mesh), instances = sizeof(Instance);
  const auto words = [](std::size_t missing, const char* what, std::size_t needed, std::size_t left) {
    return std::to_string(missing) + " bytes of memory are missing: " + what + std::to_string(needed) + ", " +
           std::to_string(left) + " are left";
  };
  EXPECT_EQ(said(tables - 8), words(8, "the scene's tables take ", tables, tables - 8));
  EXPECT_EQ(said(tables + 4), words(instances - 4, "what moves takes ", instances, 4));
  EXPECT_EQ(said(tables + instances / 8 * 8 + 8 + 8),
            words(sizeof(Font) - 8, "fonts and labels take ", sizeof(Font), 8));
  const std::string strips = said(1'500);
  EXPECT_NE(strips.find(" bytes of memory are missing: the picture takes at least "), std::string::npos) << strips;
  EXPECT_NE(strips.find("; most are for "), std::string::npos) << strips;
}

TEST(PlayerErrors, OfEffects) {
  const auto said = [](const char* scene, ChoosePipeline choose) {
    Blob blob = blob_of(scene);
    Screen screen(80, 60, hal::DisplayFormat::rgb565);
    Memory memory(1 << 20);
    Player player(memory.span(), choose);
    EXPECT_TRUE(player.open(blob.data(), blob.size())) << player.error();
    EXPECT_FALSE(player.fit(screen.display)) << scene;
    return std::string(player.error());
  };
  const std::string begin = "effects are missing that the scene or its text calls for: ";
  EXPECT_EQ(said("room", drawn_with<kTeapot>), begin + "textures, ways to shade, or sides");
  EXPECT_NE(said("fog", drawn_with<kTeapot>).find("fog"), std::string::npos);
  EXPECT_NE(said("csg", drawn_with<kTeapot>).find("csg"), std::string::npos);
  EXPECT_EQ(said("teapot_meshlets", drawn_with<kTeapot | effect::orthographic>),
            "the scene has perspective, and the player is for orthographic cameras");
}

TEST(PlayerErrors, OfTextWithoutItsEffect) {
  Lit lit;
  Player player(lit.memory.span(), drawn_with<kTeapot>);
  ASSERT_TRUE(player.open(lit.blob.data(), lit.blob.size()) && player.fit(lit.screen.display)) << player.error();
  player.show_text("abc");
  EXPECT_FALSE(player.draw(lit.screen.display));
  EXPECT_STREQ(player.error(), "effects are missing that the scene or its text calls for: overlay");
}

TEST(PlayerErrors, OfDisplays) {
  Lit lit;
  ASSERT_TRUE(lit.open_and_fit()) << lit.player.error();
  Screen other(120, 91, hal::DisplayFormat::rgb565), swapped(120, 90, hal::DisplayFormat::rgb565_swapped);
  for (Screen* each : {&other, &swapped}) {
    EXPECT_FALSE(lit.player.draw(each->display));
    EXPECT_STREQ(lit.player.error(), "the display has not the size and format that were fitted");
  }
  hal::Framebuffer broken(std::span(lit.screen.pixels).first(10), {120, 90, hal::DisplayFormat::rgb565});
  EXPECT_FALSE(lit.player.draw(broken));
  EXPECT_EQ(std::string(lit.player.error()),
            std::string("the display failed: ") + hal::message(hal::Error::framebuffer));
  int strips = 0;
  EXPECT_FALSE(lit.player.draw_strips([&strips](const Rect&, std::span<const std::byte>) { return ++strips < 1; }));
  EXPECT_STREQ(lit.player.error(), "a strip was not taken");
  EXPECT_EQ(strips, 1);
  for (const auto& [width, height] : {std::pair{0, 90}, {120, 0}, {4097, 1}}) {
    EXPECT_FALSE(
        lit.player.fit(static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height), PixelFormat::rgb565));
    EXPECT_EQ(std::string(lit.player.error()).find("the picture cannot be planned: "), 0U) << lit.player.error();
  }
  EXPECT_FALSE(lit.player.fit(8, 8, static_cast<PixelFormat>(99)));
}

TEST(PlayerErrors, OfClipping) {
  // Around so far that the teapot comes near the camera is not possible, but closer than a thousand pixels is.
  Lit lit;
  Player player(lit.memory.span(), drawn_with<kTeapot | effect::unclipped>);
  ASSERT_TRUE(player.open(lit.blob.data(), lit.blob.size()) && player.fit(lit.screen.display)) << player.error();
  player.zoom(60'000);
  EXPECT_FALSE(player.draw(lit.screen.display));
  EXPECT_EQ(std::string(player.error()), std::string("the frame cannot begin: ") + message(Error::clipping));
  player.zoom(100);
  EXPECT_TRUE(player.draw(lit.screen.display)) << player.error();
}

TEST(PlayerErrors, OfConstantsThatAreNoScene) {
  Lit lit;
  SceneBlob opened;
  Memory tables(1 << 16);
  ASSERT_TRUE(open_scene_blob(lit.blob.memory.span(), tables.span(), opened));
  std::vector<Instance> instances(opened.scene.instances.begin(), opened.scene.instances.end());
  instances[0].mesh = 77;
  Scene wrong = opened.scene;
  wrong.instances = instances;
  ASSERT_TRUE(lit.player.open({wrong, opened.camera}, opened.view));
  EXPECT_FALSE(lit.player.fit(lit.screen.display));
  EXPECT_EQ(std::string(lit.player.error()), std::string("the frame cannot begin: ") + message(Error::instance));
  EXPECT_FALSE(lit.player.draw(lit.screen.display));
  EXPECT_STREQ(lit.player.error(), "no display is fitted: fit() comes before draw()");
}

TEST(PlayerErrors, OfWhatTurnsFarAway) {
  Lit lit;
  SceneBlob opened;
  Memory tables(1 << 16);
  ASSERT_TRUE(open_scene_blob(lit.blob.memory.span(), tables.span(), opened));
  std::vector<Instance> far(opened.scene.instances.begin(), opened.scene.instances.end());
  far[0].transform.m[0][3] = scenes::kFarthestTurned + 1;
  opened.scene.instances = far;
  ASSERT_TRUE(lit.player.open({opened.scene, opened.camera, opened.animation, opened.turn}, opened.view));
  ASSERT_TRUE(lit.player.fit(lit.screen.display)) << lit.player.error();
  ASSERT_TRUE(lit.player.draw(lit.screen.display)) << lit.player.error();
  lit.player.seek(1);
  EXPECT_FALSE(lit.player.draw(lit.screen.display));
  EXPECT_STREQ(lit.player.error(), "what turns is too far from the origin for it: hold(true)");
}

/// The same blob with one byte of another value, and the checksum of those bytes.
void damage(std::span<std::byte> blob, std::uint32_t& random) {
  const auto next = [&random] { return random = random * 1664525 + 1013904223; };
  for (int i = 0; i < 1 + static_cast<int>(next() >> 30); ++i) {
    const std::size_t at = 12 + (next() >> 4) % (blob.size() - 12);
    constexpr std::uint8_t kValues[] = {0, 1, 2, 127, 128, 255};
    blob[at] = static_cast<std::byte>(kValues[(next() >> 8) % 6]);
  }
  const std::uint32_t sum = crc32(blob.subspan(12));
  for (std::size_t i = 0; i < 4; ++i) blob[8 + i] = static_cast<std::byte>(sum >> 8 * i);
}

TEST(PlayerErrors, DamagedScenesHarmNothing) {
  std::uint32_t random = 1;
  int drawn = 0, refused = 0;
  for (const char* scene : {"fog", "robot", "overlay"}) {
    Blob whole = blob_of(scene);
    Screen screen(48, 32, hal::DisplayFormat::rgb565);
    Memory memory(400'000);
    for (int i = 0; i < 300; ++i) {
      Blob blob(whole.size());
      std::ranges::copy(whole.memory.span(), blob.memory.span().begin());
      damage(blob.memory.span(), random);
      Player player(memory.span(), drawn_with_any);
      player.show_text("x", true);
      player.orbit(static_cast<Angle>(random), static_cast<Angle>(random >> 8));
      bool is_right = player.open(blob.data(), blob.size()) && player.fit(screen.display);
      for (int frame = 0; is_right && frame < 3; ++frame) {
        player.play(static_cast<std::uint32_t>(1000 * frame));
        is_right = player.draw(screen.display);
      }
      EXPECT_EQ(is_right, player.error()[0] == 0) << player.error();
      ++(is_right ? drawn : refused);
    }
  }
  EXPECT_GT(drawn, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace zstrip::test
