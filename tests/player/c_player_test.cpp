// The interface for C is the player: a program in C, and the pictures that it makes.
#include "baked.hpp"
#include "c_program.h"
#include "zstrip_player/c_picker.hpp"
#include "zstrip_player/c_pipeline.hpp"

namespace zstrip::test {
namespace {

constexpr zstrip_pipeline kAnyPipeline{drawn_with_any};
constexpr zstrip_pipeline kTeapotPipeline{
    drawn_with<effect::lighting | effect::gouraud | effect::shade_gouraud | effect::overlay>};

TEST(CPlayer, DrawsWhatARendererDraws) {
  Blob blob = blob_of("teapot_meshlets");
  const Font fonts[] = {kSmallFont};
  const Label labels[] = {{.text = std::span("C - fps"), .x = 2, .y = 2, .background = {0, 0, 0, 255}}};
  const Overlay overlay{.fonts = fonts, .labels = labels};
  const Screen screen(120, 90, hal::DisplayFormat::rgb565);
  for (const zstrip_pipeline* pipeline : {&kAnyPipeline, &kTeapotPipeline}) {
    for (const std::size_t beyond : {0U, 5U}) {
      Memory memory(20'000, beyond);
      std::vector<unsigned char> pixels(120 * 90 * 2);
      picture shown{pixels.data(), 120, 90, 0};
      const std::span<std::byte> room = memory.span();
      EXPECT_STREQ(show(&shown, blob.data(), blob.size(), room.data(), room.size(), pipeline, 333), "");
      EXPECT_GT(shown.strips, 1);
      const std::vector<std::byte> expected = drawn_directly(blob, screen, {.time = 333, .overlay = &overlay});
      EXPECT_TRUE(std::ranges::equal(std::as_bytes(std::span(pixels)), expected));
    }
  }
}

TEST(CPlayer, SaysWhatIsWrong) {
  Blob blob = blob_of("teapot_meshlets");
  std::vector<unsigned char> pixels(120 * 90 * 2);
  picture shown{pixels.data(), 120, 90, 0};
  int before = 0;
  for (std::size_t size = 0; size < 8'000; size += 250) {
    Memory memory(size);
    const std::string words = show(&shown, blob.data(), blob.size(), memory.span().data(), size, &kAnyPipeline, 0);
    const int now = words == "no room for the player"                                   ? 0
                    : words.find(" bytes of memory are missing: ") != std::string::npos ? 1
                                                                                        : 2;
    EXPECT_TRUE(now == before || now == before + 1) << size << ": " << words;
    if (now == 2) {
      EXPECT_EQ(words, "");
    }
    before = now;
  }
  EXPECT_EQ(before, 2);
  Memory memory(20'000);
  EXPECT_STREQ(show(&shown, blob.data(), 20, memory.span().data(), memory.span().size(), &kAnyPipeline, 0),
               "these bytes are no whole scene: byte 20 is wrong; bake it again");
  EXPECT_STREQ(show(&shown, blob.data(), 20, nullptr, 0, &kAnyPipeline, 0), "no room for the player");
}

TEST(CPlayer, PicksWhatAPlayerPicks) {
  constexpr zstrip_picker kAnyPicker{pick_with_any};
  constexpr zstrip_picker kTeapotPicker{
      pick_with<effect::lighting | effect::gouraud | effect::shade_gouraud | effect::overlay>};
  constexpr zstrip_picker kOther{pick_with<effect::lighting>}, kNothing{nullptr};
  Blob blob = blob_of("teapot_meshlets");
  Memory memory(20'000);
  const std::span<std::byte> room = memory.span();
  Player player(room, drawn_with_any);
  Picked wanted;
  ASSERT_TRUE(player.open(blob.data(), blob.size()) && player.fit(120, 90, PixelFormat::rgb565));
  ASSERT_TRUE(player.pick(pick_with_any, 60, 45, wanted));
  EXPECT_EQ(wanted.shown, Shown::instance);
  const auto words = [&](const zstrip_pipeline& pipeline, const zstrip_picker* picker, zstrip_picked* picked) {
    return std::string(pick_middle(picked, blob.data(), blob.size(), room.data(), room.size(), &pipeline, picker));
  };
  for (const auto& [pipeline, picker] :
       {std::pair{&kAnyPipeline, &kAnyPicker}, std::pair{&kTeapotPipeline, &kTeapotPicker}}) {
    zstrip_picked picked{};
    EXPECT_EQ(words(*pipeline, picker, &picked), "");
    EXPECT_EQ(picked.shown, ZSTRIP_INSTANCE);
    EXPECT_EQ(picked.index, wanted.index);
    EXPECT_EQ(picked.triangle, wanted.triangle);
    EXPECT_EQ(picked.textured, 0);
  }
  EXPECT_EQ(words(kAnyPipeline, &kAnyPicker, nullptr), "");
  zstrip_picked picked{};
  EXPECT_EQ(words(kAnyPipeline, nullptr, &picked), "nothing finds the pixel: the function given to pick is null");
  EXPECT_EQ(words(kAnyPipeline, &kNothing, &picked), "nothing finds the pixel: the function given to pick is null");
  EXPECT_EQ(words(kTeapotPipeline, &kOther, &picked), "the pipeline has other effects than the function given to pick");
  EXPECT_EQ(picked.shown, ZSTRIP_BACKGROUND);
  EXPECT_EQ(zstrip_player_pick(nullptr, &kAnyPicker, 0, 0, &picked), 0);
}

/// They were faults of the processor.
TEST(CPlayer, SaysThatAPointerIsNull) {
  Blob blob = blob_of("teapot_meshlets");
  Memory memory(20'000);
  const std::span<std::byte> room = memory.span();
  const zstrip_pipeline empty{};
  EXPECT_EQ(zstrip_player_in(nullptr, room.size(), &kAnyPipeline), nullptr);
  EXPECT_EQ(zstrip_player_in(room.data(), room.size(), nullptr), nullptr);
  EXPECT_EQ(zstrip_player_in(room.data(), room.size(), &empty), nullptr);
  EXPECT_STREQ(zstrip_player_error(nullptr),
               "there is no player: zstrip_player_in had no memory, too little of it, or no pipeline");

  const zstrip_take ignore = [](void*, const zstrip_strip*) { return 1; };
  EXPECT_EQ(zstrip_player_open(nullptr, blob.data(), blob.size()), 0);
  EXPECT_EQ(zstrip_player_fit(nullptr, 120, 90, ZSTRIP_RGB565, 1), 0);
  EXPECT_EQ(zstrip_player_draw(nullptr, ignore, nullptr), 0);
  zstrip_player_play(nullptr, 1);
  zstrip_player_hold(nullptr, 1);
  zstrip_player_seek(nullptr, 1);
  zstrip_player_orbit(nullptr, 1, 1);
  zstrip_player_zoom(nullptr, 1);
  zstrip_player_show_text(nullptr, "text", 1);

  zstrip_player* const player = zstrip_player_in(room.data(), room.size(), &kAnyPipeline);
  ASSERT_NE(player, nullptr);
  EXPECT_EQ(zstrip_player_open(player, nullptr, blob.size()), 0);
  EXPECT_STREQ(zstrip_player_error(player), "no scene was given: its address is null");
  zstrip_player_show_text(player, nullptr, 0);
  ASSERT_EQ(zstrip_player_open(player, blob.data(), blob.size()), 1) << zstrip_player_error(player);
  for (const long format : {7, 8, 256, -1}) EXPECT_EQ(fit_format(player, format), 0) << format;
  EXPECT_STREQ(zstrip_player_error(player),
               "the picture cannot be planned: a picture has 1 to 4096 samples a side and a known format");
  ASSERT_EQ(zstrip_player_fit(player, 120, 90, ZSTRIP_RGB565, 0), 1) << zstrip_player_error(player);
  EXPECT_EQ(zstrip_player_draw(player, nullptr, nullptr), 0);
  EXPECT_STREQ(zstrip_player_error(player), "nothing takes the strips: the function given to draw is null");
  EXPECT_EQ(zstrip_player_draw(player, ignore, nullptr), 1);
  EXPECT_STREQ(zstrip_player_error(player), "");
}

}  // namespace
}  // namespace zstrip::test
