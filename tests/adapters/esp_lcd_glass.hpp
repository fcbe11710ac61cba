// Stand-ins for the drivers of RGB panels without a frame buffer and of MIPI-DSI panels: what the glass shows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "esp_lcd_driver.hpp"
#include "esp_lcd_panel_rgb.h"

namespace zstrip::adapters_test {

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
extern RgbController controller;

/// The glass of the program for MIPI-DSI, whose driver takes strips by DMA2D.
struct DsiGlass : esp_lcd_panel_t {
  std::vector<std::uint16_t> colours;
  std::size_t width = 0;
  bool is_reset = false, is_on = false;
};
extern DsiGlass dsi_glass;

extern std::uint32_t backlight;  ///< the level of the last pin that was set

}  // namespace zstrip::adapters_test
