// The widget lv_zstrip in the real LVGL: its pixels are the player's, in every format and render mode.
#include "lv_zstrip.h"

#include <cstdlib>
#include <optional>
#include <set>

#include "gauge.h"
#include "player/baked.hpp"
#include "screen.hpp"
#include "zstrip_player/c_picker.hpp"
#include "zstrip_player/c_pipeline.hpp"

namespace zstrip::lvgl_test {
namespace {

using test::Blob;
using test::blob_of;
using test::Memory;

constexpr std::int32_t kWidth = 160, kHeight = 120;
constexpr std::int32_t kLeft = 11, kTop = 7, kAcross = 100, kDown = 80;  // of the widget
constexpr std::uint32_t kParent = 0x204060, kParent565 = 0x20 >> 3 << 11 | 0x40 >> 2 << 5 | 0x60 >> 3;

/// Counts the strips that are drawn.
std::vector<std::uint16_t> drawn_strips;
Status (*draw_strip)(detail::FrameState&, std::uint16_t, std::span<std::byte>);
DrawnWith counted(Effects called_for) {
  DrawnWith with = drawn_with_any(called_for);
  draw_strip = with.pipeline.draw_strip;
  with.pipeline.draw_strip = [](detail::FrameState& frame, std::uint16_t strip, std::span<std::byte> pixels) {
    drawn_strips.push_back(strip);
    return draw_strip(frame, strip, pixels);
  };
  return with;
}
constexpr zstrip_pipeline kPipeline{counted};
constexpr zstrip_picker kPicker{pick_with_any};

/// A scene with its memory, for a widget.
struct Scene3d {
  Blob blob;
  Memory memory;
  lv_zstrip_scene_t scene;
  explicit Scene3d(const std::string& name, std::size_t bytes = 40'000) : blob(blob_of(name)), memory(bytes) {
    scene = {blob.data(), blob.size(), memory.span().data(), bytes, &kPipeline, &kPicker};
  }
};

lv_obj_t* widget_on_screen(const Scene3d& scene, bool transparent) {
  lv_obj_set_style_bg_color(lv_screen_active(), lv_color_hex(kParent), 0);
  lv_obj_t* const widget = lv_zstrip_create(lv_screen_active());
  lv_obj_set_pos(widget, kLeft, kTop);
  lv_obj_set_size(widget, kAcross, kDown);
  lv_zstrip_set_transparent(widget, transparent);
  EXPECT_TRUE(lv_zstrip_set_scene(widget, &scene.scene)) << lv_zstrip_get_error(widget);
  lv_zstrip_pause(widget);
  return widget;
}

/// What a widget should show, by a player of its own.
struct Wanted {
  std::vector<std::uint16_t> pixels = std::vector<std::uint16_t>(kAcross * kDown);
  std::vector<std::uint8_t> mask = std::vector<std::uint8_t>(kAcross * kDown);
  Wanted(const std::string& name, std::uint32_t time, std::optional<Colour> background = {}, Angle right = 0,
         Angle up = 0, std::uint16_t zoom = 100) {
    Blob blob = blob_of(name);
    Memory memory(1 << 20);
    Player player(memory.span(), drawn_with_any);
    EXPECT_TRUE(player.open(blob.data(), blob.size()) &&
                player.fit(kAcross, kDown, PixelFormat::rgb565, {.masked = true}));
    player.seek(time);
    player.orbit(right, up);
    player.zoom(zoom);
    if (background) player.background(*background);
    EXPECT_TRUE(player.begin() && player.draw_area({0, 0, kAcross, kDown}, std::as_writable_bytes(std::span(pixels)),
                                                   2 * kAcross, mask, kAcross))
        << player.error();
  }
};

/// Counts pixels of the screen that differ: from the wanted ones in the widget, from the parent outside.
std::size_t wrong_pixels(const Screen& screen, const Wanted& wanted, bool transparent) {
  std::size_t wrong = 0;
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const std::int32_t column = x - kLeft, row = y - kTop;
      const bool inside = column >= 0 && column < kAcross && row >= 0 && row < kDown;
      const auto i = static_cast<std::size_t>(row * kAcross + column);
      const bool drawn = inside && (!transparent || wanted.mask[i] != 0);
      if (screen.rgb565(x, y) != (drawn ? wanted.pixels[i] : kParent565)) ++wrong;
    }
  }
  return wrong;
}

constexpr lv_color_format_t kFormats[] = {LV_COLOR_FORMAT_RGB565, LV_COLOR_FORMAT_RGB565_SWAPPED,
                                          LV_COLOR_FORMAT_RGB888, LV_COLOR_FORMAT_XRGB8888, LV_COLOR_FORMAT_ARGB8888};
constexpr lv_display_render_mode_t kModes[] = {LV_DISPLAY_RENDER_MODE_PARTIAL, LV_DISPLAY_RENDER_MODE_DIRECT,
                                               LV_DISPLAY_RENDER_MODE_FULL};

TEST(LvglWidget, ShowsThePlayersPixelsInEveryFormatAndMode) {
  const Wanted wanted("robot", 300);
  for (const lv_color_format_t format : kFormats) {
    for (const lv_display_render_mode_t mode : kModes) {
      Screen screen(kWidth, kHeight, format, mode);
      const Scene3d scene("robot", 60'000);
      lv_obj_t* const widget = widget_on_screen(scene, false);
      lv_zstrip_set_time(widget, 300);
      screen.run(50);
      EXPECT_EQ(wrong_pixels(screen, wanted, false), 0U) << format << ' ' << mode;
      EXPECT_EQ(logged(), "");
    }
  }
}

TEST(LvglWidget, LeavesOutTheBackgroundInEveryFormatAndMode) {
  for (const char* name : {"teapot_meshlets", "overlay"}) {
    const Wanted wanted(name, 500, Colour{0x20, 0x40, 0x60, 255});
    for (const lv_color_format_t format : kFormats) {
      for (const lv_display_render_mode_t mode : kModes) {
        Screen screen(kWidth, kHeight, format, mode);
        const Scene3d scene(name);
        lv_obj_t* const widget = widget_on_screen(scene, true);
        lv_zstrip_set_time(widget, 500);
        screen.run(50);
        EXPECT_EQ(wrong_pixels(screen, wanted, true), 0U) << name << ' ' << format << ' ' << mode;
        EXPECT_EQ(logged(), "");
      }
    }
  }
}

/// What lies between the parent and the model is seen around the model.
TEST(LvglWidget, ShowsWhatIsBehindIt) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  lv_obj_t* const behind = lv_obj_create(lv_screen_active());
  lv_obj_remove_style_all(behind);
  lv_obj_set_pos(behind, 0, 0);
  lv_obj_set_size(behind, kWidth / 2, kHeight);
  lv_obj_set_style_bg_opa(behind, LV_OPA_COVER, 0);
  lv_obj_set_style_bg_color(behind, lv_color_hex(0xF80000), 0);
  const Scene3d scene("teapot_meshlets");
  widget_on_screen(scene, true);
  screen.run(50);
  const Wanted wanted("teapot_meshlets", 0, Colour{0x20, 0x40, 0x60, 255});
  std::size_t red = 0, wrong = 0;
  for (std::int32_t y = 0; y < kDown; ++y) {
    for (std::int32_t x = 0; x < kAcross; ++x) {
      const auto i = static_cast<std::size_t>(y * kAcross + x);
      const bool over_red = kLeft + x < kWidth / 2;
      const std::uint16_t expected = wanted.mask[i] != 0 ? wanted.pixels[i] : over_red ? 0xF800 : kParent565;
      if (screen.rgb565(kLeft + x, kTop + y) != expected) ++wrong;
      if (expected == 0xF800) ++red;
    }
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_GT(red, 500U);
}

/// LVGL's pieces of a screen do not begin where strips do: the strip that reaches into the next piece is kept.
TEST(LvglWidget, DrawsEachStripOnce) {
  for (const int rows : {5, 12, 13, 120}) {
    for (const bool transparent : {false, true}) {
      Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL, rows);
      const Scene3d scene("teapot_meshlets", 14'000);
      widget_on_screen(scene, transparent);
      drawn_strips.clear();
      screen.refresh();
      const std::set<std::uint16_t> once(drawn_strips.begin(), drawn_strips.end());
      EXPECT_GT(once.size(), 3U);
      EXPECT_EQ(once.size(), drawn_strips.size()) << rows;
    }
  }
}

TEST(LvglWidget, RedrawsOnlyWhatMoved) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("home", 200'000);
  lv_obj_t* const widget = widget_on_screen(scene, false);
  screen.run(100);
  screen.forget();
  screen.run(200);
  EXPECT_EQ(screen.flushed_pixels(), 0U) << "it is paused";
  std::size_t flushed = 0;
  for (std::uint32_t time = 100; time <= 1000; time += 100) {
    screen.forget();
    lv_zstrip_set_time(widget, time);
    screen.run(20);
    flushed += screen.flushed_pixels();
    EXPECT_TRUE(screen.flushed() == screen.flushed().cut_to({kLeft, kTop, kLeft + kAcross, kTop + kDown}));
    EXPECT_EQ(wrong_pixels(screen, Wanted("home", time), false), 0U) << time;
  }
  EXPECT_GT(flushed, 0U);
  EXPECT_LT(flushed, 10U * kAcross * kDown / 2);
  // A label over the widget has its rows drawn again, and no others.
  lv_obj_t* const label = lv_label_create(lv_screen_active());
  lv_obj_set_pos(label, kLeft + 10, kTop + 10);
  screen.run(20);
  screen.forget();
  lv_label_set_text(label, "12");
  screen.run(20);
  EXPECT_LT(screen.flushed().height(), 30);
}

TEST(LvglWidget, PlaysByLvglsClock) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("clips", 200'000);
  lv_obj_t* const widget = widget_on_screen(scene, false);
  lv_zstrip_play(widget);
  screen.run(1000);
  EXPECT_NEAR(lv_zstrip_get_time(widget), 1000, 20);
  lv_zstrip_pause(widget);
  const std::uint32_t paused = lv_zstrip_get_time(widget);
  screen.run(1000);
  EXPECT_EQ(lv_zstrip_get_time(widget), paused);
  EXPECT_EQ(wrong_pixels(screen, Wanted("clips", paused), false), 0U);
  lv_zstrip_play(widget);
  lv_zstrip_set_part(widget, 3000, 5200);
  for (int i = 0; i < 60; ++i) {
    screen.run(100);
    EXPECT_GE(lv_zstrip_get_time(widget), 3000U);
    EXPECT_LT(lv_zstrip_get_time(widget), 5200U);
  }
  lv_zstrip_set_part(widget, 0, 0);
  screen.run(9000);
  EXPECT_LT(lv_zstrip_get_time(widget), 8000U) << "the motion takes 8 seconds";
}

/// It jumped to some time within the part.
TEST(LvglWidget, PlaysFromATimeBeforeItsPartUpToThePart) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("clips", 200'000);
  lv_obj_t* const widget = widget_on_screen(scene, false);
  lv_zstrip_set_part(widget, 3000, 5200);
  lv_zstrip_set_time(widget, 2000);
  lv_zstrip_play(widget);
  screen.run(500);
  EXPECT_NEAR(lv_zstrip_get_time(widget), 2500, 40);
  screen.run(1000);
  EXPECT_NEAR(lv_zstrip_get_time(widget), 3500, 40);
  screen.run(2200);
  EXPECT_NEAR(lv_zstrip_get_time(widget), 3500, 40);
}

TEST(LvglWidget, FadesFromOneClipToAnother) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("figure", 200'000);
  lv_obj_t* const widget = widget_on_screen(scene, false);
  ASSERT_EQ(lv_zstrip_get_clips(widget), 2U);
  EXPECT_EQ(lv_zstrip_get_clip_name(widget, 2), nullptr);
  EXPECT_FALSE(lv_zstrip_play_clip(widget, 2, 0, true));
  EXPECT_NE(logged().find("there is no clip 2"), std::string::npos) << logged();
  Blob blob = blob_of("figure");
  Memory memory(1 << 20);
  Player wanted(memory.span(), drawn_with_any);
  ASSERT_TRUE(wanted.open(blob.data(), blob.size()) && wanted.fit(kAcross, kDown, PixelFormat::rgb565));
  wanted.play(0);
  const auto wrong = [&] {
    std::vector<std::uint16_t> pixels(kAcross * kDown);
    EXPECT_TRUE(wanted.begin() &&
                wanted.draw_area({0, 0, kAcross, kDown}, std::as_writable_bytes(std::span(pixels)), 2 * kAcross));
    std::size_t count = 0;
    for (std::int32_t i = 0; i < kAcross * kDown; ++i) {
      if (screen.rgb565(kLeft + i % kAcross, kTop + i / kAcross) != pixels[static_cast<std::size_t>(i)]) ++count;
    }
    return count;
  };
  const std::uint32_t began = clock();
  lv_zstrip_play(widget);
  screen.run(300);
  ASSERT_TRUE(lv_zstrip_play_clip(widget, 1, 400, true));
  screen.run(200);
  lv_zstrip_pause(widget);
  screen.run(30);
  // The widget's frames follow LVGL's timers; its time says which frame is seen.
  const std::uint32_t in_clip = lv_zstrip_get_time(widget);
  EXPECT_GT(in_clip, 150U);
  EXPECT_LE(in_clip, 220U);
  const std::uint32_t before = clock() - began - 30 - in_clip;
  std::size_t fewest = kAcross * kDown;
  for (std::uint32_t first = before - 30; first <= before + 30; first += 5) {
    ASSERT_TRUE(wanted.open(blob.data(), blob.size()) && wanted.fit(kAcross, kDown, PixelFormat::rgb565));
    wanted.play(0);
    wanted.play(first);
    ASSERT_TRUE(wanted.play_clip(1, 400));
    wanted.play(first + in_clip);
    fewest = std::min(fewest, wrong());
  }
  EXPECT_EQ(fewest, 0U);
}

TEST(LvglWidget, ADragMovesTheCameraAndAClickPicks) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("teapot_meshlets");
  lv_obj_t* const widget = widget_on_screen(scene, false);
  static std::vector<zstrip_picked> picked;
  picked.clear();
  const auto keep = [](lv_event_t* e) { picked.push_back(*static_cast<const zstrip_picked*>(lv_event_get_param(e))); };
  lv_obj_add_event_cb(widget, keep, LV_EVENT_VALUE_CHANGED, nullptr);
  screen.run(50);

  screen.touch(kLeft + kAcross / 2, kTop + kDown / 2);
  screen.release();
  ASSERT_EQ(picked.size(), 1U);
  EXPECT_EQ(picked[0].shown, ZSTRIP_INSTANCE);
  EXPECT_EQ(picked[0].index, 0);
  zstrip_picked direct;
  ASSERT_TRUE(lv_zstrip_pick(widget, kAcross / 2, kDown / 2, &direct));
  EXPECT_EQ(direct.triangle, picked[0].triangle);
  EXPECT_FALSE(lv_zstrip_pick(widget, -1, 0, &direct));
  EXPECT_FALSE(lv_zstrip_pick(widget, 0, kDown, &direct));
  screen.touch(kLeft + 1, kTop + 1);
  screen.release();
  ASSERT_EQ(picked.size(), 2U);
  EXPECT_EQ(picked[1].shown, ZSTRIP_BACKGROUND);

  // A drag of the widget's width is half a turn; it is no click.
  screen.touch(kLeft + 50, kTop + 40);
  screen.touch(kLeft + 75, kTop + 40);
  screen.touch(kLeft + 75, kTop + 50);
  screen.release();
  EXPECT_EQ(picked.size(), 2U);
  EXPECT_EQ(lv_zstrip_get_orbit_right(widget), -450);
  EXPECT_EQ(lv_zstrip_get_orbit_up(widget), 180);
  EXPECT_EQ(wrong_pixels(screen, Wanted("teapot_meshlets", 0, {}, static_cast<Angle>(-8192), 3276), false), 0U);

  screen.touch(kLeft + 50, kTop + 40);
  screen.release();
  screen.roll(3);
  EXPECT_EQ(lv_zstrip_get_zoom(widget), 130);
  lv_zstrip_set_orbit(widget, 0, 130'000'000);
  EXPECT_EQ(lv_zstrip_get_orbit_up(widget), 800) << "it wrapped to the other side";
  lv_zstrip_set_orbit(widget, 1800, 3600);
  EXPECT_EQ(lv_zstrip_get_orbit_up(widget), 800);
  EXPECT_EQ(lv_zstrip_get_orbit_right(widget), -1800);
  lv_zstrip_set_interactive(widget, false);
  screen.touch(kLeft + 50, kTop + 40);
  screen.touch(kLeft + 80, kTop + 40);
  screen.release();
  EXPECT_EQ(lv_zstrip_get_orbit_right(widget), -1800);
}

TEST(LvglWidget, ADragOf65536PixelsStopsWhereAShorterOneDoes) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("teapot_meshlets");
  lv_obj_t* const widget = widget_on_screen(scene, false);
  screen.run(50);
  for (const std::int32_t pixels : {1'000, 65'535, 65'536, 100'000}) {
    screen.touch(kLeft + 50, kTop + 40);
    screen.touch(kLeft + 50, kTop + 40 + pixels);
    screen.release();
    EXPECT_EQ(lv_zstrip_get_orbit_up(widget), 800) << pixels;
    screen.touch(kLeft + 50, kTop + 40);
    screen.touch(kLeft + 50, kTop + 40 - pixels);
    screen.release();
    EXPECT_EQ(lv_zstrip_get_orbit_up(widget), -800) << pixels;
  }
}

/// It was 1800 for the last nine of 65536 angles, which only drags reach.
TEST(LvglWidget, AnAngleThatRoundsToHalfATurnIsInTheDocumentedRange) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("teapot_meshlets");
  lv_obj_t* const widget = widget_on_screen(scene, false);
  lv_obj_set_width(widget, 120);
  screen.run(50);
  lv_zstrip_set_orbit(widget, 1605, 0);  // 29218; 13 pixels to the left are 3549 more, together 32767
  screen.touch(kLeft + 60, kTop + 40);
  screen.touch(kLeft + 47, kTop + 40);
  screen.release();
  EXPECT_EQ(lv_zstrip_get_orbit_right(widget), -1800);
}

TEST(LvglWidget, AnotherSizeIsPlannedAgain) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("teapot_meshlets", 60'000);
  lv_obj_t* const widget = lv_zstrip_create(lv_screen_active());
  lv_obj_set_size(widget, 30, 150);
  ASSERT_TRUE(lv_zstrip_set_scene(widget, &scene.scene));
  lv_zstrip_pause(widget);
  screen.run(50);
  lv_obj_set_style_bg_color(lv_screen_active(), lv_color_hex(kParent), 0);
  lv_obj_set_style_border_width(widget, 3, 0);
  lv_obj_set_style_border_color(widget, lv_color_hex(kParent), 0);
  lv_obj_set_pos(widget, kLeft - 3, kTop - 3);
  lv_obj_set_size(widget, kAcross + 6, kDown + 6);
  screen.run(50);
  EXPECT_EQ(wrong_pixels(screen, Wanted("teapot_meshlets", 0), false), 0U);
  EXPECT_EQ(logged(), "");
}

/// Its size was compared with that of the last picture, so that it went on to say what was wrong.
TEST(LvglWidget, IsShownAgainAfterASizeThatCouldNotBeDrawn) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("teapot_meshlets");
  lv_obj_t* const widget = widget_on_screen(scene, false);
  lv_obj_t* const parent = lv_obj_create(lv_screen_active());
  lv_obj_remove_style_all(parent);
  lv_obj_set_pos(parent, kLeft, kTop);
  lv_obj_set_size(parent, kAcross, kDown);
  lv_obj_set_parent(widget, parent);
  lv_obj_set_pos(widget, 0, 0);
  lv_obj_set_size(widget, lv_pct(100), lv_pct(100));  // it is told its new size alone
  screen.run(50);
  lv_obj_set_size(parent, 5000, kDown);
  screen.run(50);
  EXPECT_STREQ(lv_zstrip_get_error(widget), "the widget is larger than 4096 pixels");
  lv_obj_set_size(parent, kAcross, kDown);
  screen.run(50);
  EXPECT_STREQ(lv_zstrip_get_error(widget), "");
  EXPECT_EQ(wrong_pixels(screen, Wanted("teapot_meshlets", 0), false), 0U);
}

TEST(LvglWidget, SaysWhatIsWrongOnTheScreenAndInTheLog) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  lv_obj_set_style_bg_color(lv_screen_active(), lv_color_hex(kParent), 0);
  lv_obj_t* const widget = lv_zstrip_create(lv_screen_active());
  lv_obj_set_pos(widget, kLeft, kTop);
  lv_obj_set_size(widget, kAcross, kDown);
  screen.run(50);
  const auto words_are_seen = [&] {
    std::size_t seen = 0;
    for (std::int32_t i = 0; i < kAcross * kDown; ++i) {
      if (screen.rgb565(kLeft + i % kAcross, kTop + i / kAcross) != kParent565) ++seen;
    }
    return seen > 100;
  };
  EXPECT_FALSE(words_are_seen());
  for (const std::size_t bytes : {100U, 2'500U, 4'000U}) {
    const Scene3d scene("teapot_meshlets", bytes);
    EXPECT_FALSE(lv_zstrip_set_scene(widget, &scene.scene));
    const std::string words = lv_zstrip_get_error(widget);
    EXPECT_NE(words.find("memory"), std::string::npos) << words;
    EXPECT_NE(logged().find(words), std::string::npos);
    screen.run(50);
    EXPECT_TRUE(words_are_seen());
    EXPECT_FALSE(lv_zstrip_play_clip(widget, 0, 0, true));
    EXPECT_EQ(lv_zstrip_get_error(widget), words) << "a clip that the scene lacks has no words on the screen";
  }
  EXPECT_TRUE(lv_zstrip_set_scene(widget, nullptr));
  screen.run(50);
  EXPECT_FALSE(words_are_seen());
  EXPECT_STREQ(lv_zstrip_get_error(widget), "");
  zstrip_picked picked;
  EXPECT_FALSE(lv_zstrip_pick(widget, 1, 1, &picked));
}

/// Words that are too long were drawn into the padding, in some of LVGL's pieces.
TEST(LvglWidget, WordsStayInItsContent) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("teapot_meshlets", 100);
  lv_obj_set_style_bg_color(lv_screen_active(), lv_color_hex(kParent), 0);
  lv_obj_t* const widget = lv_zstrip_create(lv_screen_active());
  lv_obj_set_pos(widget, kLeft, kTop);
  lv_obj_set_size(widget, kAcross, 30);
  lv_obj_set_style_pad_all(widget, 5, 0);
  EXPECT_FALSE(lv_zstrip_set_scene(widget, &scene.scene));
  screen.run(50);
  std::size_t inside = 0, outside = 0;
  for (std::int32_t i = 0; i < kAcross * 30; ++i) {
    const std::int32_t x = i % kAcross, y = i / kAcross;
    const bool is_content = x >= 5 && x < kAcross - 5 && y >= 5 && y < 25;
    if (screen.rgb565(kLeft + x, kTop + y) != kParent565) ++(is_content ? inside : outside);
  }
  EXPECT_GT(inside, 50U);
  EXPECT_EQ(outside, 0U);
}

TEST(LvglWidget, NamesAFormatThatCannotShowIt) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_I1, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("teapot_meshlets");
  widget_on_screen(scene, false);
  screen.run(50);
  EXPECT_NE(logged().find("a display of this colour format cannot show RGB565: lv_color_format_t 7"), std::string::npos)
      << logged();
}

/// The decoder of a display that is gone would be LVGL's freed memory.
TEST(LvglWidget, ServesSeveralWidgetsAndAnotherLvglAfterwards) {
  for (int again = 0; again < 2; ++again) {
    Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
    const Scene3d scene("teapot_meshlets"), other("robot", 60'000);
    lv_obj_t* const above = widget_on_screen(other, false);
    lv_obj_t* const below = widget_on_screen(scene, false);
    lv_obj_move_foreground(above);
    screen.run(50);
    EXPECT_EQ(wrong_pixels(screen, Wanted("robot", 0), false), 0U);
    lv_obj_delete(above);
    screen.run(50);
    EXPECT_EQ(wrong_pixels(screen, Wanted("teapot_meshlets", 0), false), 0U);
    lv_obj_delete(below);
    screen.run(50);
    EXPECT_EQ(screen.rgb565(kLeft + 50, kTop + 40), kParent565);
  }
}

/// A layer that LVGL rotates is LVGL's own memory; the widget only draws into it.
TEST(LvglWidget, IsRotatedAndScaledByLvglsStyles) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("robot", 60'000);
  lv_obj_t* const widget = widget_on_screen(scene, false);
  lv_obj_set_style_transform_pivot_x(widget, kAcross / 2, 0);
  lv_obj_set_style_transform_pivot_y(widget, kDown / 2, 0);
  lv_obj_set_style_transform_rotation(widget, 1800, 0);
  screen.run(50);
  const Wanted wanted("robot", 0);
  std::size_t near = 0;
  for (std::int32_t y = 4; y < kDown - 4; ++y) {
    for (std::int32_t x = 4; x < kAcross - 4; ++x) {
      // LVGL interpolates: a pixel is near one of its neighbours.
      const std::uint32_t seen = screen.rgb565(kLeft + x, kTop + y) >> 11;
      bool found = false;
      for (std::int32_t side = -1; side <= 1; ++side) {
        for (std::int32_t step = -1; step <= 1; ++step) {
          const auto i = static_cast<std::size_t>((kDown - 1 - y + side) * kAcross + kAcross - 1 - x + step);
          const std::uint32_t red = wanted.pixels[i] >> 11;
          if (red <= seen + 2 && seen <= red + 2) found = true;
        }
      }
      if (found) ++near;
    }
  }
  EXPECT_GT(near, std::size_t{(kDown - 8) * (kAcross - 8) * 97 / 100});
  EXPECT_EQ(logged(), "");
}

/// A canvas of the same size takes 16,000 bytes for its pixels alone.
TEST(LvglWidget, TakesLittleMemoryOfLvgl) {
  Screen screen(kWidth, kHeight, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL);
  const Scene3d scene("teapot_meshlets", 9'500);
  lv_mem_monitor_t before, after;
  lv_mem_monitor(&before);
  widget_on_screen(scene, false);
  screen.run(50);
  lv_mem_monitor(&after);
  EXPECT_LT(before.free_size - after.free_size, 1200U);
  EXPECT_EQ(wrong_pixels(screen, Wanted("teapot_meshlets", 0), false), 0U);
}

/// With LV_ZSTRIP_PICTURES=FOLDER it leaves its screens there, for a look.
TEST(LvglGauge, ShowsAModelUnderLabelsAndChangesItsClip) {
  Screen screen(240, 240, LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL, 24);
  const Scene3d scene("clips", 60'000);
  ASSERT_TRUE(show_gauge(lv_screen_active(), &scene.scene)) << logged();
  const char* const folder = std::getenv("LV_ZSTRIP_PICTURES");
  const auto save = [&](const char* name) {
    if (folder != nullptr) screen.save(std::string(folder) + '/' + name + ".ppm");
  };
  screen.run(1500);
  save("walk");
  std::vector<std::uint16_t> before;
  for (std::int32_t i = 0; i < 144 * 144; ++i) before.push_back(screen.rgb565(48 + i % 144, 34 + i / 144));
  screen.touch(205, 218);
  screen.release();
  screen.run(600);
  save("wave");
  std::size_t differ = 0;
  for (std::int32_t i = 0; i < 144 * 144; ++i) {
    if (before[static_cast<std::size_t>(i)] != screen.rgb565(48 + i % 144, 34 + i / 144)) ++differ;
  }
  EXPECT_GT(differ, 500U);
  screen.touch(205, 218);
  screen.release();
  screen.touch(120, 110);
  screen.release();
  screen.run(600);
  save("run");
  screen.touch(120, 110);
  screen.touch(150, 120);
  screen.release();
  save("orbit");
  EXPECT_EQ(logged(), "");
}

}  // namespace
}  // namespace zstrip::lvgl_test
