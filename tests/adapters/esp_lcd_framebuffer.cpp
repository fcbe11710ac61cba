// Stand-ins for panels of esp_lcd with a frame buffer: the driver of MIPI-DSI calls its callback when DMA2D has copied
// a strip, or before draw_bitmap() returns; that of RGB copies and calls none.
#include "esp_lcd_driver.hpp"
#include "esp_lcd_dsi.hpp"
#include "esp_lcd_rgb.hpp"
#include "libraries.hpp"

namespace {

using namespace zstrip::adapters_test;

esp_lcd_panel_t panel_copied_to{[](const zstrip::hal::Area& area, const void* pixels) {
  screen().draw(area, pixels, First::low);
  has_taken();
  return ESP_OK;
}};
esp_lcd_panel_t panel_with_dma2d{[](const zstrip::hal::Area& area, const void* pixels) {
  screen().begin(area, pixels, First::low);
  return ESP_OK;
}};

struct EspLcdDsiParts {
  adapters::EspLcdDsi adapter{&panel_copied_to, kWidth, kHeight};
};
struct EspLcdDsiByDmaParts {
  adapters::EspLcdDsi adapter{&panel_with_dma2d, kWidth, kHeight};
};
struct EspLcdRgbFramebufferParts {
  adapters::EspLcdRgbFramebuffer adapter{&panel_copied_to, kWidth, kHeight};
};

}  // namespace

esp_err_t esp_lcd_dpi_panel_register_event_callbacks(esp_lcd_panel_handle_t panel,
                                                     const esp_lcd_dpi_panel_event_callbacks_t* callbacks,
                                                     void* context) {
  return register_callback([panel, done = callbacks->on_color_trans_done, context] { done(panel, nullptr, context); });
}

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_esp_lcd_dsi() { return std::make_unique<Opened<EspLcdDsiParts>>(); }
std::unique_ptr<panel::AnyDisplay> open_esp_lcd_dsi_by_dma() { return std::make_unique<Opened<EspLcdDsiByDmaParts>>(); }
std::unique_ptr<panel::AnyDisplay> open_esp_lcd_rgb_framebuffer() {
  has_taken = [] {};
  return std::make_unique<Opened<EspLcdRgbFramebufferParts>>();
}
}  // namespace zstrip::adapters_test
