// This header declares the names of esp_lcd of ESP-IDF 5 that the program of `zstrip bake
// --project esp_idf` calls.
#pragma once

#include "driver/gpio.h"
#include "esp_lcd_panel_ops.h"

using esp_lcd_spi_bus_handle_t = int;
struct esp_lcd_panel_io_spi_config_t {
  gpio_num_t cs_gpio_num, dc_gpio_num;
  int spi_mode;
  unsigned pclk_hz;
  unsigned trans_queue_depth;
  int lcd_cmd_bits, lcd_param_bits;
};
esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus, const esp_lcd_panel_io_spi_config_t* config,
                                   esp_lcd_panel_io_handle_t* io);
struct esp_lcd_panel_dev_config_t {
  unsigned bits_per_pixel;
  gpio_num_t reset_gpio_num;
  void* vendor_config;
};
esp_err_t esp_lcd_new_panel_st7789(esp_lcd_panel_io_handle_t io, const esp_lcd_panel_dev_config_t* config,
                                   esp_lcd_panel_handle_t* panel);
