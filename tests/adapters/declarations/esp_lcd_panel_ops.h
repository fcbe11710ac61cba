// Of esp_lcd of ESP-IDF 5: the names that the adapter calls.
#pragma once

#include "esp_lcd_panel_io.h"

using esp_lcd_panel_handle_t = struct esp_lcd_panel_t*;
esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start, int x_end, int y_end,
                                    const void* colours);
