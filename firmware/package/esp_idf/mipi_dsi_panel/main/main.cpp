// Shows a baked model on a MIPI-DSI panel with 1024x600 pixels, an EK79007 as on the ESP32-P4-Function-EV-Board. The
// model is that of the sketch Player; `zstrip bake MODEL -o scene.hpp --turntable` makes your own.
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <driver/gpio.h>
#include <esp_idf_version.h>
#include <esp_lcd_ek79007.h>
#include <esp_lcd_mipi_dsi.h>
#include <esp_lcd_panel_ops.h>
#include <esp_ldo_regulator.h>
#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>
#include <zstrip_player/player.hpp>

#include "esp_lcd_dsi.hpp"
#include "scene.hpp"

constexpr int kReset = 27, kBacklight = 26;  // of the board; a panel of another maker also has other timings, below
constexpr std::uint16_t kWidth = 1024, kHeight = 600;

static std::byte memory[160 * 1024];  // arena, two strips, and what moves
static zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);

// Returns null if the panel does not start.
static esp_lcd_panel_handle_t start_glass() {
  esp_ldo_channel_config_t power{};
  power.chan_id = 3;  // the chip's regulator that the lanes are wired to
  power.voltage_mv = 2500;
  esp_ldo_channel_handle_t regulator = nullptr;
  if (esp_ldo_acquire_channel(&power, &regulator) != ESP_OK) return nullptr;

  esp_lcd_dsi_bus_config_t lanes{};
  lanes.num_data_lanes = 2;
  lanes.lane_bit_rate_mbps = 1000;
  esp_lcd_dsi_bus_handle_t bus = nullptr;
  if (esp_lcd_new_dsi_bus(&lanes, &bus) != ESP_OK) return nullptr;
  esp_lcd_dbi_io_config_t commands{};
  commands.lcd_cmd_bits = 8;
  commands.lcd_param_bits = 8;
  esp_lcd_panel_io_handle_t io = nullptr;
  if (esp_lcd_new_panel_io_dbi(bus, &commands, &io) != ESP_OK) return nullptr;

  esp_lcd_dpi_panel_config_t pixels{};
  pixels.dpi_clk_src = MIPI_DSI_DPI_CLK_SRC_DEFAULT;
  pixels.dpi_clock_freq_mhz = 48;
#if ESP_IDF_VERSION < ESP_IDF_VERSION_VAL(6, 0, 0)
  pixels.pixel_format = LCD_COLOR_PIXEL_FORMAT_RGB565;
  pixels.flags.use_dma2d = 1;
#else
  pixels.in_color_format = LCD_COLOR_FMT_RGB565;
#endif
  pixels.num_fbs = 1;
  pixels.video_timing.h_size = kWidth;
  pixels.video_timing.v_size = kHeight;
  pixels.video_timing.hsync_pulse_width = 10;
  pixels.video_timing.hsync_back_porch = 120;
  pixels.video_timing.hsync_front_porch = 120;
  pixels.video_timing.vsync_pulse_width = 1;
  pixels.video_timing.vsync_back_porch = 20;
  pixels.video_timing.vsync_front_porch = 10;

  ek79007_vendor_config_t vendor{};
  vendor.mipi_config.dsi_bus = bus;
  vendor.mipi_config.dpi_config = &pixels;
  esp_lcd_panel_dev_config_t config{};
  config.reset_gpio_num = static_cast<gpio_num_t>(kReset);
  config.bits_per_pixel = 16;
  config.vendor_config = &vendor;
  esp_lcd_panel_handle_t glass = nullptr;
  if (esp_lcd_new_panel_ek79007(io, &config, &glass) != ESP_OK) return nullptr;
#if ESP_IDF_VERSION >= ESP_IDF_VERSION_VAL(6, 0, 0)
  if (esp_lcd_dpi_panel_enable_dma2d(glass) != ESP_OK) return nullptr;
#endif
  if (esp_lcd_panel_reset(glass) != ESP_OK || esp_lcd_panel_init(glass) != ESP_OK) return nullptr;
  return glass;
}

extern "C" void app_main() {
  const esp_lcd_panel_handle_t glass = start_glass();
  static adapters::EspLcdDsi panel(glass, kWidth, kHeight);
  if (glass == nullptr || panel.start() != zstrip::hal::Error::none) {
    std::puts("the panel does not start");
    return;
  }
  gpio_set_direction(static_cast<gpio_num_t>(kBacklight), GPIO_MODE_OUTPUT);
  gpio_set_level(static_cast<gpio_num_t>(kBacklight), 1);
  const bool opened = player.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView);
  if (!opened || !player.fit(panel, {.strip_buffers = 2})) {
    std::puts(player.error());
    return;
  }
  for (;;) {
    player.play(static_cast<std::uint32_t>(esp_timer_get_time() / 1000));
    if (!player.draw(panel)) std::puts(player.error());
    vTaskDelay(1);  // the idle task runs, which the watchdog wants
  }
}
