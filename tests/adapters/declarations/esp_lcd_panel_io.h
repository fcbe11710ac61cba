// Declares what the adapter calls of esp_lcd, as ESP-IDF 5 does.
#pragma once

using esp_err_t = int;
inline constexpr esp_err_t ESP_OK = 0;

using esp_lcd_panel_io_handle_t = struct esp_lcd_panel_io_t*;
struct esp_lcd_panel_io_event_data_t {};
using esp_lcd_panel_io_color_trans_done_cb_t = bool (*)(esp_lcd_panel_io_handle_t io,
                                                        esp_lcd_panel_io_event_data_t* data, void* context);
struct esp_lcd_panel_io_callbacks_t {
  esp_lcd_panel_io_color_trans_done_cb_t on_color_trans_done;
};
esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t io,
                                                    const esp_lcd_panel_io_callbacks_t* callbacks, void* context);
