// RGB and MIPI-DSI panels of esp_lcd: EspLcdRgb feeds a stand-in for the driver of RGB panels that has no frame buffer,
// and the programs of the package for both show a picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "esp_lcd_glass.hpp"
#include "esp_lcd_rgb.hpp"
#include "esp_timer.h"
#include "scene.hpp"  // of the sketch Player
#include "screen.hpp"
#include "zstrip_hal/framebuffer.hpp"
#include "zstrip_player/player.hpp"

extern "C" void rgb_panel_main();
extern "C" void mipi_dsi_panel_main();

namespace zstrip::adapters_test {
namespace {

constexpr std::uint16_t kGlassWidth = 60, kGlassHeight = 48, kGlassRows = 8;

esp_lcd_panel_handle_t open_glass(std::uint16_t rows) {
  esp_lcd_rgb_panel_config_t config{};
  config.timings.h_res = kGlassWidth;
  config.timings.v_res = kGlassHeight;
  config.data_width = 16;
  config.bounce_buffer_size_px = std::size_t{kGlassWidth} * rows;
  config.flags.no_fb = 1;
  esp_lcd_panel_handle_t panel = nullptr;
  EXPECT_EQ(esp_lcd_new_rgb_panel(&config, &panel), ESP_OK);
  return panel;
}

/// The model of the sketch Player.
class Model {
 public:
  Model() { EXPECT_TRUE(player_.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView)); }
  /// Returns the message about what was wrong.
  template <class Panel>
  std::string draw(Panel& panel, std::uint32_t time) {
    if (!is_fitted_ && !player_.fit(panel, {.strip_rows = kGlassRows})) return player_.error();
    is_fitted_ = true;
    player_.seek(time);
    return player_.draw(panel) ? "" : player_.error();
  }

 private:
  alignas(8) std::array<std::byte, 20 * 1024> memory_{};
  Player player_{memory_, drawn_with<baked::kEffects>};
  bool is_fitted_ = false;
};

std::vector<std::uint16_t> model_in_memory(std::uint32_t time) {
  std::vector<std::uint16_t> colours(kGlassWidth * kGlassHeight);
  hal::Framebuffer framebuffer{std::as_writable_bytes(std::span(colours)),
                               {kGlassWidth, kGlassHeight, hal::DisplayFormat::rgb565}};
  EXPECT_EQ(Model().draw(framebuffer, time), "");
  return colours;
}

/// Pixels of more than one colour, and all of them drawn.
bool is_picture(const std::vector<std::uint16_t>& colours) {
  return !colours.empty() && std::ranges::count(colours, 0xDEAD) == 0 &&
         std::ranges::count(colours, colours.front()) != static_cast<std::ptrdiff_t>(colours.size());
}

TEST(EspLcdRgb, ShowsWhatIsDrawnToMemory) {
  controller = {};
  adapters::EspLcdRgb panel(open_glass(kGlassRows), kGlassWidth, kGlassHeight, kGlassRows);
  ASSERT_EQ(panel.start(), hal::Error::none);
  ASSERT_EQ(esp_lcd_panel_init(&controller), ESP_OK);
  Model model;
  for (const std::uint32_t time : {0U, 700U, 1400U}) {
    EXPECT_EQ(model.draw(panel, time), "");
    EXPECT_EQ(controller.shown(), model_in_memory(time)) << time;
  }
}

TEST(EspLcdRgb, TellsThatAStripIsLateAndGoesOn) {
  controller = {};
  adapters::EspLcdRgb panel(open_glass(kGlassRows), kGlassWidth, kGlassHeight, kGlassRows);
  ASSERT_EQ(panel.start(), hal::Error::none);
  ASSERT_EQ(esp_lcd_panel_init(&controller), ESP_OK);
  Model model;
  EXPECT_EQ(model.draw(panel, 0), "");
  for (int strips = 0; strips < 3; ++strips) controller.read();
  EXPECT_NE(model.draw(panel, 700).find(hal::message(hal::Error::underrun)), std::string::npos);
  EXPECT_EQ(model.draw(panel, 700), "");
  EXPECT_EQ(controller.shown(), model_in_memory(700));
}

TEST(EspLcdRgb, TellsWhatTheDriverTells) {
  controller = {};
  screen() = {};
  for (const std::uint16_t rows : {std::uint16_t{0}, std::uint16_t{16}, std::uint16_t{7}}) {
    adapters::EspLcdRgb odd(&controller, kGlassWidth, kGlassHeight, rows);
    EXPECT_EQ(odd.start(), hal::Error::strip_layout) << rows;
  }
  adapters::EspLcdRgb panel(open_glass(kGlassRows), kGlassWidth, kGlassHeight, kGlassRows);
  screen().fault = Fault::start;
  EXPECT_EQ(panel.start(), hal::Error::bus);
  screen().fault = Fault::none;
  ASSERT_EQ(panel.start(), hal::Error::none);
  // Nobody has called esp_lcd_panel_init().
  ASSERT_EQ(panel.begin_frame(), hal::Error::none);
  const std::vector<std::byte> pixels(std::size_t{2} * kGlassWidth * kGlassRows);
  EXPECT_EQ(panel.write({0, 0, kGlassWidth, kGlassRows}, pixels), hal::Error::timeout);
}

// The programs run until they ask for the time of a frame that is not theirs.
struct EndOfProgram {};
int frames_left = 0;

TEST(EspIdfPrograms, ShowAPictureOnARgbPanel) {
  controller = {};
  backlight = 0;
  frames_left = 3;
  EXPECT_THROW(rgb_panel_main(), EndOfProgram);
  EXPECT_EQ(controller.glass.size(), 480U * 272);
  EXPECT_TRUE(is_picture(controller.shown()));
  EXPECT_EQ(backlight, 1);
}

TEST(EspIdfPrograms, ShowAPictureOnAMipiDsiPanel) {
  screen() = {};
  backlight = 0;
  frames_left = 2;
  EXPECT_THROW(mipi_dsi_panel_main(), EndOfProgram);
  EXPECT_EQ(dsi_glass.colours.size(), 1024U * 600);
  EXPECT_TRUE(is_picture(dsi_glass.colours));
  EXPECT_TRUE(dsi_glass.is_on);
  EXPECT_EQ(backlight, 1);
  EXPECT_EQ(screen().complaint, "");
}

}  // namespace
}  // namespace zstrip::adapters_test

std::int64_t esp_timer_get_time() {
  using zstrip::adapters_test::frames_left;
  if (frames_left-- == 0) throw zstrip::adapters_test::EndOfProgram{};
  return std::int64_t{700'000} * frames_left;
}
