// The drivers' functions; see esp_lcd_glass.hpp.
#include "esp_lcd_glass.hpp"

#include <cstring>
#include <span>

#include <driver/gpio.h>
#include <esp_lcd_ek79007.h>
#include <esp_lcd_panel_vendor.h>
#include <esp_ldo_regulator.h>
#include <esp_rom_sys.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>

#include "screen.hpp"

namespace zstrip::adapters_test {
RgbController controller;
DsiGlass dsi_glass;
std::uint32_t backlight = 0;
}  // namespace zstrip::adapters_test

using namespace zstrip::adapters_test;

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
