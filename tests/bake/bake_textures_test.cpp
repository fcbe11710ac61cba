// Palettes and mipmaps that `zstrip bake` makes: what they lose, and how many bytes they take.
#include <algorithm>
#include <tuple>

#include "bake_fixture.hpp"

namespace zstrip::sim::test {
namespace {

/// The room's walls have 3 colours in 256 texels, its box more than 16 in 4096.
TEST_F(Bake, PalettesThatLoseNothingChangeNoPixel) {
  const Json plain = report({"bake", "room", "-o", "plain.zsc"});
  EXPECT_EQ(plain.at("flash_bytes").at("textures"), 2 * (256 + 4096));
  EXPECT_EQ(plain.at("palettes"), Json::array());
  EXPECT_EQ(crcs("plain.zsc", {}, 1), crcs("room", {}, 1));

  const Json baked = report({"bake", "room", "-o", "small.zsc", "--textures", "auto"});
  const int bytes = 2 * (16 + 256 / 4 + 256 + 4096 / 2);
  EXPECT_EQ(baked.at("flash_bytes").at("textures"), bytes);
  EXPECT_EQ(plain.at("palettes_would_save"), 2 * (256 + 4096) - bytes);
  EXPECT_EQ(baked.at("palettes_would_save"), 0);
  ASSERT_EQ(baked.at("palettes").size(), 2U);
  const Json& of_walls = baked.at("palettes").at(0);
  EXPECT_EQ(of_walls.at("bits"), 4);
  EXPECT_EQ(of_walls.at("bytes_before"), 512);
  EXPECT_EQ(of_walls.at("bytes"), 160);
  EXPECT_EQ(of_walls.at("largest_error"), (std::vector{0, 0, 0}));
  EXPECT_EQ(baked.at("effects").back().at("name"), "texture_palettes");
  EXPECT_EQ(crcs("small.zsc", {}, 1), crcs("room", {}, 1));
  EXPECT_EQ(crcs("small.zsc", {}, 5), crcs("plain.zsc", {}, 5));

  report({"bake", "small.zsc", "-o", "again.zsc"});
  EXPECT_EQ(read(path("again.zsc")), read(path("small.zsc")));
}

TEST_F(Bake, MipmapsWhereTheSceneAsksForThemOrEverywhereOrNowhere) {
  const std::string scene = ZSTRIP_SCENE_FILES "/mipmaps.toml";
  const auto levels = [](int texels) {  // of a square, all but the first
    int sum = 0;
    for (; texels > 1; texels /= 4) sum += texels / 4;
    return sum;
  };
  const Json asked = report({"bake", scene, "-o", "asked.zsc"});
  ASSERT_EQ(asked.at("mipmaps").size(), 1U) << "the material on the right";
  EXPECT_EQ(asked.at("mipmaps").at(0).at("smaller_levels"), 6);
  EXPECT_EQ(asked.at("mipmaps").at(0).at("bytes"), 2 * levels(4096));
  const auto effect =
      std::ranges::find_if(asked.at("effects"), [](const Json& e) { return e.at("name") == "mipmaps"; });
  ASSERT_NE(effect, asked.at("effects").end());
  EXPECT_EQ(effect->at("materials"), Json::array({"tiles with mipmaps"}));
  EXPECT_EQ(crcs("asked.zsc", {"--size", "320x240"}, 1), crcs(scene, {"--size", "320x240"}, 1));
  report({"bake", "asked.zsc", "-o", "again.zsc", "--size", "320x240"});
  report({"bake", scene, "-o", "asked.zsc", "--size", "320x240"});
  EXPECT_EQ(read(path("again.zsc")), read(path("asked.zsc")));

  const Json off = report({"bake", scene, "-o", "off.zsc", "--mipmaps", "off"});
  EXPECT_EQ(off.at("mipmaps"), Json::array());
  EXPECT_EQ(off.at("flash_bytes").at("textures"), 2 * 2 * 4096);
  EXPECT_EQ(report({"bake", scene, "-o", "on.zsc", "--mipmaps", "on"}).at("mipmaps").size(), 2U);

  // The room: levels for its walls and its box, and a finish for their materials; with palettes of all levels.
  const Json room = report({"bake", "room", "-o", "room.zsc", "--mipmaps", "on"});
  EXPECT_EQ(room.at("mipmaps").size(), 2U);
  EXPECT_EQ(room.at("flash_bytes").at("textures"), 2 * (256 + levels(256) + 4096 + levels(4096)));
  EXPECT_NE(crcs("room.zsc", {}, 1), crcs("room", {}, 1));
  const Json small = report({"bake", "room", "-o", "small.zsc", "--mipmaps", "on", "--textures", "auto"});
  ASSERT_EQ(small.at("palettes").size(), 2U);
  EXPECT_EQ(small.at("palettes").at(0).at("largest_error"), (std::vector{0, 0, 0}));
  EXPECT_EQ(crcs("small.zsc", {}, 3), crcs("room.zsc", {}, 3));

  const Outcome words = zstrip({"bake", scene, "-o", "scene.hpp"});
  EXPECT_NE(words.out.find("  mipmaps    texture 1: 2,730 bytes for 6 smaller levels\n"), std::string::npos)
      << words.out;
  EXPECT_NE(read(path("scene.hpp")).find(".smaller_levels = 6"), std::string::npos);
  EXPECT_EQ(zstrip({"bake", scene, "-o", "scene.hpp", "--mipmaps", "some"}).status, 2);
}

TEST_F(Bake, PalettesThatLoseSomethingSayHowMuch) {
  const std::string scene = ZSTRIP_SCENE_FILES "/palette.toml";
  const auto baked = [&](const char* textures) {
    return report({"bake", scene, "-o", "scene.zsc", "--textures", textures}).at("palettes");
  };
  EXPECT_EQ(baked("rgb565"), Json::array());
  EXPECT_EQ(baked("auto"), Json::array()) << "more than 256 colours";
  for (const auto& [choice, bits, bytes] :
       {std::tuple{"palette8", 8, 2 * (256 + 2048)}, {"palette4", 4, 2 * (16 + 1024)}}) {
    const Json palettes = baked(choice);
    ASSERT_EQ(palettes.size(), 1U) << "the other two have one already";
    EXPECT_EQ(palettes.at(0).at("bits"), bits);
    EXPECT_EQ(palettes.at(0).at("bytes"), bytes);
    EXPECT_EQ(palettes.at(0).at("bytes_before"), 2 * 4096);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double largest = palettes.at(0).at("largest_error").at(channel);
      const double mean = palettes.at(0).at("mean_error").at(channel);
      EXPECT_GT(mean, 0);
      EXPECT_LT(mean, largest);
      EXPECT_LT(largest, 96);
    }
  }
  const Outcome words = zstrip({"bake", scene, "-o", "scene.hpp", "--textures", "palette8"});
  EXPECT_NE(words.out.find("  palettes   texture 0: 256 colours, 4,608 instead of 8,192 bytes: at most "),
            std::string::npos)
      << words.out;
  const Outcome advice = zstrip({"bake", "room", "-o", "scene.hpp"});
  EXPECT_NE(advice.out.find("--textures auto would save 3,936 bytes"), std::string::npos) << advice.out;
}

}  // namespace
}  // namespace zstrip::sim::test
