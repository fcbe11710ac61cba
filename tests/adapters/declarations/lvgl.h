// Of LVGL 9: the names that the adapter and docs/displays.md call.
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
struct lv_timer_t;
#define LV_DRAW_BUF_DEFINE_STATIC(name, width, height, format) static lv_draw_buf_t name
#define LV_DRAW_BUF_INIT_STATIC(name) static_cast<void>(name)

lv_draw_buf_t* lv_canvas_get_draw_buf(lv_obj_t* canvas);
void* lv_draw_buf_goto_xy(const lv_draw_buf_t* buffer, std::uint32_t x, std::uint32_t y);
void lv_obj_invalidate(const lv_obj_t* object);
lv_obj_t* lv_canvas_create(lv_obj_t* parent);
void lv_canvas_set_draw_buf(lv_obj_t* canvas, lv_draw_buf_t* buffer);
lv_timer_t* lv_timer_create(void (*callback)(lv_timer_t*), std::uint32_t milliseconds, void* user_data);
void* lv_timer_get_user_data(lv_timer_t* timer);
void lv_timer_pause(lv_timer_t* timer);
std::uint32_t lv_tick_get();
