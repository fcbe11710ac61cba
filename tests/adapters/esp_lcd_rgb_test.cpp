// RGB and MIPI-DSI panels of esp_lcd: EspLcdRgb feeds a stand-in for the driver of RGB panels that has no frame buffer,
// and the programs of the package for both show a picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "esp_lcd_driver.hpp"
#include "esp_lcd_ek79007.h"
#include "esp_lcd_panel_vendor.h"
#include "esp_lcd_rgb.hpp"
#include "esp_ldo_regulator.h"
#include "esp_timer.h"
#include "scene.hpp"  // of the sketch Player
#include "zstrip_hal/framebuffer.hpp"
#include "zstrip_player/player.hpp"

extern "C" void rgb_panel_main();
extern "C" void mipi_dsi_panel_main();

namespace zstrip::adapters_test {
namespace {

/// The controller reads two bounce buffers in turn. The driver fills the one that was read, in the order in which it
/// counts since the last refresh began.
struct RgbController : esp_lcd_panel_t {
  esp_lcd_rgb_panel_config_t config{};
  esp_lcd_rgb_panel_event_callbacks_t callbacks{};
  void* context = nullptr;
  std::vector<std::uint16_t> buffers[2], glass;
  int next_pixel = 0;  // of the picture, that the driver asks for
  std::size_t strips_read = 0;
  bool runs = false;

  std::size_t strips() const { return config.timings.v_res * config.timings.h_res / config.bounce_buffer_size_px; }
  bool configure(const esp_lcd_rgb_panel_config_t& with) {
    config = with;
    const std::size_t pixels = config.bounce_buffer_size_px;
    if (config.flags.no_fb == 0 || config.data_width != 16 || pixels == 0) return false;
    if (config.timings.v_res * config.timings.h_res % pixels != 0) return false;
    buffers[0].assign(pixels, 0xDEAD);
    buffers[1] = buffers[0];
    glass.assign(config.timings.v_res * config.timings.h_res, 0xDEAD);
    next_pixel = 0;
    strips_read = 0;
    runs = false;
    return true;
  }
  void fill(std::vector<std::uint16_t>& buffer) {
    const int pixels = static_cast<int>(buffer.size());
    if (callbacks.on_bounce_empty != nullptr)
      callbacks.on_bounce_empty(this, buffer.data(), next_pixel, 2 * pixels, context);
    next_pixel = (next_pixel + pixels) % static_cast<int>(glass.size());
  }
  void start() {
    runs = true;
    fill(buffers[0]);
    fill(buffers[1]);
  }
  /// Returns the picture that the glass has when both buffers were read, after the last strip of a frame.
  std::vector<std::uint16_t> shown() const {
    std::vector<std::uint16_t> picture = glass;
    for (std::size_t strip = strips_read; strip < strips(); ++strip) {
      const std::vector<std::uint16_t>& buffer = buffers[strip % 2];
      std::copy(buffer.begin(), buffer.end(), picture.begin() + static_cast<std::ptrdiff_t>(strip * buffer.size()));
    }
    return picture;
  }
  /// The controller has read a strip.
  void read() {
    std::vector<std::uint16_t>& buffer = buffers[strips_read % 2];
    std::copy(buffer.begin(), buffer.end(), glass.begin() + static_cast<std::ptrdiff_t>(strips_read * buffer.size()));
    fill(buffer);
    strips_read = (strips_read + 1) % strips();
  }
};
RgbController controller;
std::uint32_t backlight = 0;

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
                               {kGlassWidth, kGlassHeight, hal::PixelFormat::rgb565}};
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

/// The glass of the program for MIPI-DSI, whose driver takes strips by DMA2D.
struct DsiGlass : esp_lcd_panel_t {
  std::vector<std::uint16_t> colours;
  std::size_t width = 0;
  bool is_reset = false, is_on = false;
};
DsiGlass dsi_glass;

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

using namespace zstrip::adapters_test;

std::int64_t esp_timer_get_time() {
  if (frames_left-- == 0) throw EndOfProgram{};
  return std::int64_t{700'000} * frames_left;
}
void vTaskDelay(TickType_t) {}
int gpio_set_direction(gpio_num_t, gpio_mode_t) { return ESP_OK; }
int gpio_set_level(gpio_num_t, std::uint32_t level) {
  backlight = level;
  return ESP_OK;
}

esp_err_t esp_lcd_new_rgb_panel(const esp_lcd_rgb_panel_config_t* config, esp_lcd_panel_handle_t* panel) {
  *panel = &controller;
  return controller.configure(*config) ? ESP_OK : 0x102;
}
esp_err_t esp_lcd_rgb_panel_register_event_callbacks(esp_lcd_panel_handle_t,
                                                     const esp_lcd_rgb_panel_event_callbacks_t* callbacks,
                                                     void* context) {
  controller.callbacks = *callbacks;
  controller.context = context;
  return screen().fault == Fault::start ? 0x103 : ESP_OK;
}
esp_err_t esp_lcd_panel_reset(esp_lcd_panel_handle_t panel) {
  if (panel == &dsi_glass) dsi_glass.is_reset = true;
  return ESP_OK;
}
esp_err_t esp_lcd_panel_init(esp_lcd_panel_handle_t panel) {
  if (panel == &controller) controller.start();
  if (panel == &dsi_glass) dsi_glass.is_on = dsi_glass.is_reset;
  return ESP_OK;
}
// The clock of the adapter for RGB panels: a strip is read in each two calls.
void esp_rom_delay_us(std::uint32_t) {
  static int calls = 0;
  if (controller.runs && ++calls % 2 == 0) controller.read();
}

esp_err_t esp_ldo_acquire_channel(const esp_ldo_channel_config_t* config, esp_ldo_channel_handle_t*) {
  return config->chan_id == 3 && config->voltage_mv == 2500 ? ESP_OK : 0x102;
}
esp_err_t esp_lcd_new_dsi_bus(const esp_lcd_dsi_bus_config_t* config, esp_lcd_dsi_bus_handle_t*) {
  return config->num_data_lanes == 2 ? ESP_OK : 0x102;
}
esp_err_t esp_lcd_new_panel_io_dbi(esp_lcd_dsi_bus_handle_t, const esp_lcd_dbi_io_config_t* config,
                                   esp_lcd_panel_io_handle_t*) {
  return config->lcd_cmd_bits == 8 && config->lcd_param_bits == 8 ? ESP_OK : 0x102;
}
esp_err_t esp_lcd_new_panel_ek79007(esp_lcd_panel_io_handle_t, const esp_lcd_panel_dev_config_t* config,
                                    esp_lcd_panel_handle_t* panel) {
  const auto* vendor = static_cast<const ek79007_vendor_config_t*>(config->vendor_config);
  const esp_lcd_dpi_panel_config_t& pixels = *vendor->mipi_config.dpi_config;
  if (config->bits_per_pixel != 16 || pixels.flags.use_dma2d == 0) return 0x102;
  dsi_glass.width = pixels.video_timing.h_size;
  dsi_glass.colours.assign(dsi_glass.width * pixels.video_timing.v_size, 0xDEAD);
  dsi_glass.draw = [](const zstrip::hal::Area& area, const void* strip) {
    screen().begin(strip, std::size_t{2} * area.width * area.height, [area](std::span<const std::byte> bytes) {
      for (std::size_t row = 0; row < area.height; ++row) {
        std::memcpy(&dsi_glass.colours[(area.top + row) * dsi_glass.width + area.left],
                    bytes.data() + 2 * row * area.width, std::size_t{2} * area.width);
      }
    });
    return ESP_OK;
  };
  *panel = &dsi_glass;
  return ESP_OK;
}
