// This header declares the names of the component esp_lcd_ek79007 that the program for a MIPI-DSI panel calls.
#pragma once

#include <cstdint>

#include "esp_lcd_mipi_dsi.h"
#include "esp_lcd_panel_vendor.h"

struct ek79007_vendor_config_t {
  struct {
    esp_lcd_dsi_bus_handle_t dsi_bus;
    const esp_lcd_dpi_panel_config_t* dpi_config;
    std::uint8_t lane_num;
  } mipi_config;
};
esp_err_t esp_lcd_new_panel_ek79007(esp_lcd_panel_io_handle_t io, const esp_lcd_panel_dev_config_t* config,
                                    esp_lcd_panel_handle_t* panel);
