// Declares what the adapter of RGB panels and its program call of esp_lcd, as ESP-IDF 5 does.
#pragma once

#include <cstddef>
#include <cstdint>

#include "driver/gpio.h"
#include "esp_lcd_panel_ops.h"

struct esp_lcd_rgb_timing_t {
  std::uint32_t pclk_hz, h_res, v_res;
  std::uint32_t hsync_pulse_width, hsync_back_porch, hsync_front_porch;
  std::uint32_t vsync_pulse_width, vsync_back_porch, vsync_front_porch;
  struct {
    std::uint32_t pclk_active_neg : 1;
  } flags;
};
inline constexpr int LCD_CLK_SRC_DEFAULT = 1;
struct esp_lcd_rgb_panel_config_t {
  int clk_src;
  esp_lcd_rgb_timing_t timings;
  std::size_t data_width, bounce_buffer_size_px;
  gpio_num_t hsync_gpio_num, vsync_gpio_num, de_gpio_num, pclk_gpio_num, disp_gpio_num, data_gpio_nums[24];
  struct {
    std::uint32_t no_fb : 1;
  } flags;
};
esp_err_t esp_lcd_new_rgb_panel(const esp_lcd_rgb_panel_config_t* config, esp_lcd_panel_handle_t* panel);

using esp_lcd_rgb_panel_bounce_buf_fill_cb_t = bool (*)(esp_lcd_panel_handle_t panel, void* buffer, int first_pixel,
                                                        int bytes, void* context);
struct esp_lcd_rgb_panel_event_callbacks_t {
  esp_lcd_rgb_panel_bounce_buf_fill_cb_t on_bounce_empty;
};
esp_err_t esp_lcd_rgb_panel_register_event_callbacks(esp_lcd_panel_handle_t panel,
                                                     const esp_lcd_rgb_panel_event_callbacks_t* callbacks,
                                                     void* context);
