// zstrip on MIPI-DSI panels of esp_lcd, ESP-IDF 5.3 or later (ESP32-P4): draw_bitmap() copies each strip into the
// panel's frame buffer, which the driver has in PSRAM.
// Needs the component esp_lcd, esp_lcd.hpp, and a DPI panel whose frame buffer is RGB565, which was reset and
// initialised. With DMA2D (flags.use_dma2d up to release 5.5, esp_lcd_dpi_panel_enable_dma2d() from 6.0 on) one strip
// is copied while the next one is drawn: take two strip buffers. Without it the processor copies, and one is enough.
// Format: rgb565. The panel shows strips as they arrive, so for one refresh it may show a part of the new frame.
#pragma once

#include <esp_lcd_mipi_dsi.h>

#include "esp_lcd.hpp"

namespace adapters {

class EspLcdDsi : public EspLcd {
 public:
  static constexpr auto kFormat = zstrip::hal::DisplayFormat::rgb565;

  EspLcdDsi(esp_lcd_panel_handle_t panel, std::uint16_t width, std::uint16_t height)
      : EspLcd(nullptr, panel, width, height) {}

  /// Call it once, before the first frame. Registers the panel's callbacks. Error::bus: that failed.
  Error start() {
    esp_lcd_dpi_panel_event_callbacks_t callbacks{};
    callbacks.on_color_trans_done = &has_copied;
    prepare();
    return registered(esp_lcd_dpi_panel_register_event_callbacks(panel(), &callbacks, this));
  }
  zstrip::hal::DisplayFormat format() const { return kFormat; }

 private:
  static bool has_copied(esp_lcd_panel_handle_t, esp_lcd_dpi_panel_event_data_t*, void* self) {
    return static_cast<EspLcdDsi*>(self)->end_write();
  }
};
static_assert(zstrip::hal::Display<EspLcdDsi>);

}  // namespace adapters
