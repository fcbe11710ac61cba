// Of Zephyr 4.4, and with ZEPHYR_4_2 of 4.2: the names that the adapter calls.
#pragma once

#include <cstdint>

#include "zephyr/device.h"

#ifdef ZEPHYR_4_2
enum display_pixel_format { PIXEL_FORMAT_RGB_888 = 1, PIXEL_FORMAT_RGB_565 = 16, PIXEL_FORMAT_BGR_565 = 32 };
#else
#define PANEL_PIXEL_FORMAT_RGB_565X (1 << 5)
enum display_pixel_format { PIXEL_FORMAT_RGB_888 = 1, PIXEL_FORMAT_RGB_565 = 16, PIXEL_FORMAT_RGB_565X = 32 };
#endif
struct display_capabilities {
  std::uint16_t x_resolution, y_resolution;
  display_pixel_format current_pixel_format;
};
struct display_buffer_descriptor {
  std::uint32_t buf_size;
  std::uint16_t width, height, pitch;
  bool frame_incomplete;
};
void display_get_capabilities(const struct device* dev, struct display_capabilities* capabilities);
int display_write(const struct device* dev, std::uint16_t x, std::uint16_t y,
                  const struct display_buffer_descriptor* descriptor, const void* buffer);
int display_set_pixel_format(const struct device* dev, display_pixel_format format);
int display_blanking_off(const struct device* dev);
