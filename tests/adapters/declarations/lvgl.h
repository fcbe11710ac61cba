// Of LVGL 9: the names that the adapter calls.
#pragma once

#include <cstdint>

enum lv_color_format_t { LV_COLOR_FORMAT_RGB565 = 0x12, LV_COLOR_FORMAT_ARGB8888 = 0x10 };
struct lv_image_header_t {
  std::uint32_t cf : 8;
  std::uint32_t w : 16;
  std::uint32_t h : 16;
  std::uint32_t stride : 16;
};
struct lv_draw_buf_t {
  lv_image_header_t header;
  std::uint8_t* data;
};
struct lv_obj_t;

lv_draw_buf_t* lv_canvas_get_draw_buf(lv_obj_t* canvas);
void* lv_draw_buf_goto_xy(const lv_draw_buf_t* buffer, std::uint32_t x, std::uint32_t y);
void lv_obj_invalidate(const lv_obj_t* object);
