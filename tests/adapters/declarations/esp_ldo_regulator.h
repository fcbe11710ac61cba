// This header declares the names of ESP-IDF 5.3 that the program for a MIPI-DSI panel calls.
#pragma once

#include "esp_lcd_panel_io.h"

using esp_ldo_channel_handle_t = struct esp_ldo_regulator_channel_t*;
struct esp_ldo_channel_config_t {
  int chan_id, voltage_mv;
};
esp_err_t esp_ldo_acquire_channel(const esp_ldo_channel_config_t* config, esp_ldo_channel_handle_t* channel);
