// The MIPI-DSI panel of this program. Fill in the pins of your board, and what the panel's data sheet says: the values
// below are those of the ESP32-P4-Function-EV-Board and its panel with 1024x600 pixels, whose controller is an EK79007.
// For another controller take its component instead of esp_lcd_ek79007 in idf_component.yml, its header, and the last
// part of create().
#pragma once

#include <cstdint>

#include <driver/gpio.h>
#include <esp_idf_version.h>
#include <esp_lcd_ek79007.h>
#include <esp_lcd_mipi_dsi.h>
#include <esp_lcd_panel_ops.h>
#include <esp_ldo_regulator.h>

namespace glass {

constexpr int kReset = 27;      // -1: not wired to the processor
constexpr int kBacklight = 26;  // -1: not switched
// The chip's regulator that the board wires to the supply of the lanes (VDD_MIPI_DPHY), and its voltage.
constexpr int kLaneSupply = 3, kLaneMillivolts = 2500;

constexpr unsigned kLanes = 2, kLaneMegabits = 1000;  // a second, of each lane
// Million pixels a second. Each refresh takes (width + the three of HSYNC) * (height + the three of VSYNC) of them: 60
// refreshes a second here.
constexpr unsigned kMegahertz = 48;
constexpr unsigned kHsyncPulse = 10, kHsyncBackPorch = 120, kHsyncFrontPorch = 120;  // pixels
constexpr unsigned kVsyncPulse = 1, kVsyncBackPorch = 20, kVsyncFrontPorch = 10;     // rows

inline gpio_num_t pin(int number) { return static_cast<gpio_num_t>(number); }

// Creates the panel, with a picture in PSRAM into which DMA2D copies strips, and switches it on. Returns null if a
// driver refuses a value above; its log says which.
inline esp_lcd_panel_handle_t create(std::uint16_t width, std::uint16_t height) {
  esp_ldo_channel_config_t power{};
  power.chan_id = kLaneSupply;
  power.voltage_mv = kLaneMillivolts;
  esp_ldo_channel_handle_t regulator = nullptr;
  if (esp_ldo_acquire_channel(&power, &regulator) != ESP_OK) return nullptr;

  esp_lcd_dsi_bus_config_t lanes{};
  lanes.num_data_lanes = kLanes;
  lanes.lane_bit_rate_mbps = kLaneMegabits;
  esp_lcd_dsi_bus_handle_t bus = nullptr;
  if (esp_lcd_new_dsi_bus(&lanes, &bus) != ESP_OK) return nullptr;
  esp_lcd_dbi_io_config_t commands{};
  commands.lcd_cmd_bits = 8;
  commands.lcd_param_bits = 8;
  esp_lcd_panel_io_handle_t io = nullptr;
  if (esp_lcd_new_panel_io_dbi(bus, &commands, &io) != ESP_OK) return nullptr;

  esp_lcd_dpi_panel_config_t pixels{};
  pixels.dpi_clk_src = MIPI_DSI_DPI_CLK_SRC_DEFAULT;
  pixels.dpi_clock_freq_mhz = kMegahertz;
#if ESP_IDF_VERSION < ESP_IDF_VERSION_VAL(6, 0, 0)
  pixels.pixel_format = LCD_COLOR_PIXEL_FORMAT_RGB565;
  pixels.flags.use_dma2d = 1;
#else
  pixels.in_color_format = LCD_COLOR_FMT_RGB565;
#endif
  pixels.num_fbs = 1;
  pixels.video_timing.h_size = width;
  pixels.video_timing.v_size = height;
  pixels.video_timing.hsync_pulse_width = kHsyncPulse;
  pixels.video_timing.hsync_back_porch = kHsyncBackPorch;
  pixels.video_timing.hsync_front_porch = kHsyncFrontPorch;
  pixels.video_timing.vsync_pulse_width = kVsyncPulse;
  pixels.video_timing.vsync_back_porch = kVsyncBackPorch;
  pixels.video_timing.vsync_front_porch = kVsyncFrontPorch;

  ek79007_vendor_config_t vendor{};
  vendor.mipi_config.dsi_bus = bus;
  vendor.mipi_config.dpi_config = &pixels;
  vendor.mipi_config.lane_num = kLanes;
  esp_lcd_panel_dev_config_t config{};
  config.reset_gpio_num = pin(kReset);
  config.bits_per_pixel = 16;
  config.vendor_config = &vendor;
  esp_lcd_panel_handle_t panel = nullptr;
  if (esp_lcd_new_panel_ek79007(io, &config, &panel) != ESP_OK) return nullptr;
#if ESP_IDF_VERSION >= ESP_IDF_VERSION_VAL(6, 0, 0)
  if (esp_lcd_dpi_panel_enable_dma2d(panel) != ESP_OK) return nullptr;
#endif
  if (esp_lcd_panel_reset(panel) != ESP_OK || esp_lcd_panel_init(panel) != ESP_OK) return nullptr;
  return panel;
}

// Switches the backlight on.
inline void light() {
  if (kBacklight < 0) return;
  gpio_set_direction(pin(kBacklight), GPIO_MODE_OUTPUT);
  gpio_set_level(pin(kBacklight), 1);
}

}  // namespace glass
