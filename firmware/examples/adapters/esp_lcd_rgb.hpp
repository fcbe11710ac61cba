// zstrip on RGB (parallel) panels of esp_lcd, ESP-IDF 5.0.1 or later.
// EspLcdRgb: on an ESP32-S3, without a picture in memory. The two bounce buffers of the driver are the strips, and
// each strip is drawn in every refresh of the panel, in time (docs/displays.md, "Panels without memory"). Call
// esp_lcd_new_rgb_panel() with flags.no_fb, 16 data lines and bounce_buffer_size_px = width * rows, then start(), and
// esp_lcd_panel_init() after it, which starts the controller. CONFIG_LCD_RGB_ISR_IRAM_SAFE must be off.
// EspLcdRgbFramebuffer: the driver has the picture, in PSRAM, and copies strips into it. The panel was initialised.
// Format of both: rgb565.
#pragma once

#include <esp_lcd_panel_rgb.h>
#include <esp_rom_sys.h>
#include <sdkconfig.h>
#include <zstrip_hal/scanned_panel.hpp>

#include "esp_lcd.hpp"

namespace adapters {

class EspLcdRgbFramebuffer : public EspLcd {
 public:
  static constexpr auto kFormat = zstrip::hal::DisplayFormat::rgb565;

  EspLcdRgbFramebuffer(esp_lcd_panel_handle_t panel, std::uint16_t width, std::uint16_t height)
      : EspLcd(nullptr, panel, width, height) {}

  /// Call it once, before the first frame.
  Error start() {
    prepare();
    return registered(ESP_OK);
  }
  zstrip::hal::DisplayFormat format() const { return kFormat; }
  /// The processor copies the strip before this returns.
  Error write(const zstrip::hal::Area& area, std::span<const std::byte> pixels) {
    const Error error = EspLcd::write(area, pixels);
    if (error == Error::none) end_write();
    return error;
  }
};
static_assert(zstrip::hal::Display<EspLcdRgbFramebuffer>);

// A bounce buffer that lies behind a cache (ESP32-P4) is written back by the driver as soon as it was asked for, before
// it is drawn.
#ifndef CONFIG_SOC_CACHE_INTERNAL_MEM_VIA_L1CACHE
struct EspDelay {
  void wait(std::uint32_t microseconds) { esp_rom_delay_us(microseconds); }
};
inline EspDelay esp_delay;

class EspLcdRgb : public zstrip::hal::ScannedPanel<EspDelay> {
 public:
  using Error = zstrip::hal::Error;

  /// `rows`: of a strip. The panel must have an even number of strips of that height: from ESP-IDF 5.4 on the driver
  /// counts from its first bounce buffer in each refresh, and with an odd number confuses the two.
  EspLcdRgb(esp_lcd_panel_handle_t panel, std::uint16_t width, std::uint16_t height, std::uint16_t rows)
      : ScannedPanel(esp_delay, {.width = width, .height = height, .rows = rows}), panel_(panel), rows_(rows) {}

  /// Call it once, before esp_lcd_panel_init(). Error::strip_layout: the strips are not as above. Error::bus: the
  /// driver refused the callback. present() and write() return Error::timeout if the controller does not ask.
  Error start() {
    if (rows_ == 0 || height() % (2 * rows_) != 0) return Error::strip_layout;
    esp_lcd_rgb_panel_event_callbacks_t callbacks{};
    callbacks.on_bounce_empty = &is_empty;
    return esp_lcd_rgb_panel_register_event_callbacks(panel_, &callbacks, this) == ESP_OK ? Error::none : Error::bus;
  }

 private:
  static bool is_empty(esp_lcd_panel_handle_t, void* buffer, int first_pixel, int bytes, void* self) {
    auto& panel = *static_cast<EspLcdRgb*>(self);
    panel.ask({static_cast<std::byte*>(buffer), static_cast<std::size_t>(bytes)},
              static_cast<std::uint16_t>(first_pixel / (panel.width() * panel.rows_)));
    return false;
  }

  esp_lcd_panel_handle_t panel_;
  std::uint16_t rows_;
};
static_assert(zstrip::hal::Display<EspLcdRgb>);
#endif

}  // namespace adapters
