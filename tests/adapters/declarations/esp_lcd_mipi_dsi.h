// Declares what the adapter of MIPI-DSI panels and its program call of esp_lcd, as ESP-IDF 5.3 does.
#pragma once

#include <cstdint>

#include "esp_lcd_panel_ops.h"

using esp_lcd_dsi_bus_handle_t = struct esp_lcd_dsi_bus_t*;
struct esp_lcd_dsi_bus_config_t {
  int bus_id;
  std::uint8_t num_data_lanes;
  std::uint32_t lane_bit_rate_mbps;
};
esp_err_t esp_lcd_new_dsi_bus(const esp_lcd_dsi_bus_config_t* config, esp_lcd_dsi_bus_handle_t* bus);
struct esp_lcd_dbi_io_config_t {
  std::uint8_t virtual_channel;
  int lcd_cmd_bits, lcd_param_bits;
};
esp_err_t esp_lcd_new_panel_io_dbi(esp_lcd_dsi_bus_handle_t bus, const esp_lcd_dbi_io_config_t* config,
                                   esp_lcd_panel_io_handle_t* io);

enum lcd_color_rgb_pixel_format_t { LCD_COLOR_PIXEL_FORMAT_RGB565 };
enum mipi_dsi_dpi_clock_source_t { MIPI_DSI_DPI_CLK_SRC_DEFAULT = 1 };
struct esp_lcd_video_timing_t {
  std::uint32_t h_size, v_size;
  std::uint32_t hsync_pulse_width, hsync_back_porch, hsync_front_porch;
  std::uint32_t vsync_pulse_width, vsync_back_porch, vsync_front_porch;
};
struct esp_lcd_dpi_panel_config_t {
  std::uint8_t virtual_channel;
  mipi_dsi_dpi_clock_source_t dpi_clk_src;
  std::uint32_t dpi_clock_freq_mhz;
  lcd_color_rgb_pixel_format_t pixel_format;
  std::uint8_t num_fbs;
  esp_lcd_video_timing_t video_timing;
  struct {
    std::uint32_t use_dma2d : 1;
  } flags;
};

struct esp_lcd_dpi_panel_event_data_t {};
using esp_lcd_dpi_panel_color_trans_done_cb_t = bool (*)(esp_lcd_panel_handle_t panel,
                                                         esp_lcd_dpi_panel_event_data_t* data, void* context);
struct esp_lcd_dpi_panel_event_callbacks_t {
  esp_lcd_dpi_panel_color_trans_done_cb_t on_color_trans_done;
};
esp_err_t esp_lcd_dpi_panel_register_event_callbacks(esp_lcd_panel_handle_t panel,
                                                     const esp_lcd_dpi_panel_event_callbacks_t* callbacks,
                                                     void* context);
