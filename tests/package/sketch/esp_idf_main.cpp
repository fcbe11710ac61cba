// PROGRAM PICTURE: runs the program for ESP-IDF that it is linked with, on a stand-in for esp_lcd (tests/adapters).
// When it asks for the time of its 21st frame the screen is compared with PICTURE. Exit status 1 if anything is wrong.
#include <cstdlib>

#include <driver/spi_master.h>
#include <esp_lcd_panel_vendor.h>
#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>

#include "compare_screen.hpp"
#include "esp_lcd_driver.hpp"

extern "C" void app_main();

namespace {
const char* picture = nullptr;
bool has_bus = false, has_io = false, is_reset = false, is_initialised = false, is_inverted = false, is_on = false;

// A panel must have been started in this order.
esp_err_t after(bool before, bool& done) {
  done = before;
  return before ? ESP_OK : 0x103;
}
}  // namespace

int gpio_set_direction(gpio_num_t, gpio_mode_t) { return ESP_OK; }
int gpio_set_level(gpio_num_t, std::uint32_t) { return ESP_OK; }
esp_err_t spi_bus_initialize(spi_host_device_t, const spi_bus_config_t* bus, int) {
  return after(bus->max_transfer_sz > 0 && bus->miso_io_num < 0, has_bus);
}
esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus, const esp_lcd_panel_io_spi_config_t* config,
                                   esp_lcd_panel_io_handle_t*) {
  return after(has_bus && bus == SPI2_HOST && config->lcd_cmd_bits == 8 && config->lcd_param_bits == 8, has_io);
}
esp_err_t esp_lcd_new_panel_st7789(esp_lcd_panel_io_handle_t, const esp_lcd_panel_dev_config_t* config,
                                   esp_lcd_panel_handle_t* panel) {
  *panel = &zstrip::adapters_test::panel_on_spi;
  return has_io && config->bits_per_pixel == 16 ? ESP_OK : 0x102;
}
esp_err_t esp_lcd_panel_reset(esp_lcd_panel_handle_t) { return after(has_io, is_reset); }
esp_err_t esp_lcd_panel_init(esp_lcd_panel_handle_t) { return after(is_reset, is_initialised); }
esp_err_t esp_lcd_panel_invert_color(esp_lcd_panel_handle_t, bool invert) {
  return after(is_initialised && invert, is_inverted);
}
esp_err_t esp_lcd_panel_swap_xy(esp_lcd_panel_handle_t, bool) { return ESP_OK; }
esp_err_t esp_lcd_panel_mirror(esp_lcd_panel_handle_t, bool, bool) { return ESP_OK; }
esp_err_t esp_lcd_panel_set_gap(esp_lcd_panel_handle_t, int, int) { return ESP_OK; }
esp_err_t esp_lcd_panel_disp_on_off(esp_lcd_panel_handle_t, bool on) { return after(is_inverted && on, is_on); }
void vTaskDelay(TickType_t) {}
std::int64_t esp_timer_get_time() {
  static int turns = 0;
  if (++turns > 20) std::exit(is_on ? zstrip::package::compare_screen(picture) : 1);
  return std::int64_t{33'000} * turns;
}

int main(int count, char** words) {
  if (count != 2) return 2;
  picture = words[1];
  app_main();
  return 1;  // only after a failure
}
