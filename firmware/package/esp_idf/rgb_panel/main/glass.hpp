// The RGB panel of this program. Fill in the pins of your board, and the timings of the panel's data sheet: those below
// are of an ESP32-4827S043 and its panel with 480x272 pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include <driver/gpio.h>
#include <esp_lcd_panel_rgb.h>

namespace glass {

// Pins of the colours, each colour from its lowest bit: five of blue, six of green, five of red.
constexpr int kColours[] = {8, 3, 46, 9, 1, 5, 6, 7, 15, 16, 4, 45, 48, 47, 21, 14};
// Pins of the clock (PCLK or DCLK), HSYNC, VSYNC and DE. -1: the panel has no such pin.
constexpr int kPixelClock = 42, kHsync = 39, kVsync = 41, kDataEnable = 40;
constexpr int kDisplayOn = -1;  // DISP; -1: not wired to the processor
constexpr int kBacklight = 2;   // -1: not switched

// Pixels a second. Each refresh takes (width + the three of HSYNC) * (height + the three of VSYNC) of them: 57
// refreshes a second here. If frames are late, take a slower clock, as far as the data sheet allows.
constexpr unsigned kHertz = 9'000'000;
constexpr unsigned kHsyncPulse = 4, kHsyncBackPorch = 43, kHsyncFrontPorch = 8;  // pixels
constexpr unsigned kVsyncPulse = 4, kVsyncBackPorch = 12, kVsyncFrontPorch = 8;  // rows
constexpr bool kFallingEdge = true;  // the processor changes the data at the falling edge of the clock

inline gpio_num_t pin(int number) { return static_cast<gpio_num_t>(number); }

// Creates the driver without a picture in memory: two bounce buffers of `strip_rows` rows take its place. Returns null
// if the driver refuses a value above; its log says which.
inline esp_lcd_panel_handle_t create(std::uint16_t width, std::uint16_t height, std::uint16_t strip_rows) {
  esp_lcd_rgb_panel_config_t config{};
  config.clk_src = LCD_CLK_SRC_DEFAULT;
  config.timings.pclk_hz = kHertz;
  config.timings.h_res = width;
  config.timings.v_res = height;
  config.timings.hsync_pulse_width = kHsyncPulse;
  config.timings.hsync_back_porch = kHsyncBackPorch;
  config.timings.hsync_front_porch = kHsyncFrontPorch;
  config.timings.vsync_pulse_width = kVsyncPulse;
  config.timings.vsync_back_porch = kVsyncBackPorch;
  config.timings.vsync_front_porch = kVsyncFrontPorch;
  config.timings.flags.pclk_active_neg = kFallingEdge;
  config.data_width = std::size(kColours);
  config.bounce_buffer_size_px = std::size_t{width} * strip_rows;
  config.hsync_gpio_num = pin(kHsync);
  config.vsync_gpio_num = pin(kVsync);
  config.de_gpio_num = pin(kDataEnable);
  config.pclk_gpio_num = pin(kPixelClock);
  config.disp_gpio_num = pin(kDisplayOn);
  std::transform(std::begin(kColours), std::end(kColours), std::begin(config.data_gpio_nums), pin);
  config.flags.no_fb = 1;
  esp_lcd_panel_handle_t panel = nullptr;
  return esp_lcd_new_rgb_panel(&config, &panel) == ESP_OK ? panel : nullptr;
}

// Switches the backlight on. Call it after the first frame, so that the panel does not show noise.
inline void light() {
  if (kBacklight < 0) return;
  gpio_set_direction(pin(kBacklight), GPIO_MODE_OUTPUT);
  gpio_set_level(pin(kBacklight), 1);
}

}  // namespace glass
