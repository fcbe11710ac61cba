// A stand-in for the drivers of esp_lcd.
#pragma once

#include <functional>
#include <utility>

#include "esp_lcd_panel_ops.h"
#include "screen.hpp"

/// Takes the pixels of draw_bitmap() for a panel.
struct esp_lcd_panel_t {
  std::function<esp_err_t(const zstrip::hal::Area& area, const void* pixels)> draw;
};

namespace zstrip::adapters_test {

/// A panel on SPI, which shows what it takes on screen().
extern esp_lcd_panel_t panel_on_spi;

/// Calls the callback that an adapter has registered for a strip that was taken; nothing on a panel without callbacks.
inline std::function<void()> has_taken = [] {};

inline esp_err_t register_callback(std::function<void()> call) {
  has_taken = std::move(call);
  return screen().fault == Fault::start ? 0x103 : ESP_OK;
}

}  // namespace zstrip::adapters_test
