// A display, a pointer and a clock of LVGL, in memory.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "lvgl.h"
#include "zstrip/view.hpp"

namespace zstrip::lvgl_test {

/// LVGL's clock and log, and the pointer's state; LVGL's callbacks have no context.
inline std::uint32_t& clock() {
  static std::uint32_t milliseconds = 0;
  return milliseconds;
}
inline std::string& logged() {
  static std::string text;
  return text;
}

/// LVGL with one display. Its pixels are those that were flushed.
class Screen {
 public:
  /// `rows`: of the buffer in LV_DISPLAY_RENDER_MODE_PARTIAL.
  Screen(std::int32_t width, std::int32_t height, lv_color_format_t format, lv_display_render_mode_t mode,
         int rows = 12)
      : width_(width), height_(height), format_(format), mode_(mode), bytes_(lv_color_format_get_size(format)) {
    clock() = 1000;
    logged().clear();
    lv_init();
    lv_tick_set_cb([] { return clock(); });
    lv_log_register_print_cb([](lv_log_level_t, const char* words) { logged() += words; });
    display_ = lv_display_create(width, height);
    lv_display_set_color_format(display_, format);
    const bool partial = mode == LV_DISPLAY_RENDER_MODE_PARTIAL;
    const std::size_t palette = format == LV_COLOR_FORMAT_I1 ? 8 : 0;
    buffer_.resize((static_cast<std::size_t>(width * (partial ? rows : height)) * bytes_ + palette) / 4 + 4);
    pixels_.resize(static_cast<std::size_t>(width * height) * bytes_);
    lv_display_set_buffers(
        display_, buffer_.data(), nullptr,
        static_cast<std::uint32_t>(static_cast<std::size_t>(width * (partial ? rows : height)) * bytes_ + palette),
        mode);
    lv_display_set_user_data(display_, this);
    lv_display_set_flush_cb(display_, [](lv_display_t* display, const lv_area_t* area, std::uint8_t* pixels) {
      static_cast<Screen*>(lv_display_get_user_data(display))->take(*area, pixels);
      lv_display_flush_ready(display);
    });
    pointer_ = lv_indev_create();
    lv_indev_set_type(pointer_, LV_INDEV_TYPE_POINTER);
    lv_indev_set_user_data(pointer_, this);
    lv_indev_set_read_cb(pointer_, [](lv_indev_t* indev, lv_indev_data_t* data) {
      auto& screen = *static_cast<Screen*>(lv_indev_get_user_data(indev));
      data->point = screen.finger_;
      data->state = screen.is_pressed_ ? LV_INDEV_STATE_PRESSED : LV_INDEV_STATE_RELEASED;
      data->enc_diff = screen.wheel_;
      screen.wheel_ = 0;
    });
  }
  ~Screen() { lv_deinit(); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// Lets LVGL work until so many milliseconds have passed.
  void run(std::uint32_t milliseconds) {
    for (std::uint32_t passed = 0; passed < milliseconds; passed += 5) {
      clock() += 5;
      lv_timer_handler();
    }
  }
  /// Draws what is invalid, without timers.
  void refresh() { lv_refr_now(display_); }

  void touch(std::int32_t x, std::int32_t y) { finger_ = {x, y}, is_pressed_ = true, run(40); }
  void release() { is_pressed_ = false, run(40); }
  void roll(std::int16_t steps) { wheel_ = steps, run(40); }

  /// Returns a pixel as RGB565; those of wider formats lose their lower bits.
  std::uint16_t rgb565(std::int32_t x, std::int32_t y) const {
    const std::uint8_t* const p = &pixels_[static_cast<std::size_t>(y * width_ + x) * bytes_];
    if (format_ == LV_COLOR_FORMAT_RGB565) return static_cast<std::uint16_t>(p[0] | p[1] << 8);
    if (format_ == LV_COLOR_FORMAT_RGB565_SWAPPED) return static_cast<std::uint16_t>(p[1] | p[0] << 8);
    return static_cast<std::uint16_t>(p[2] >> 3 << 11 | p[1] >> 2 << 5 | p[0] >> 3);
  }
  /// The smallest rectangle of all flushes since forget().
  Rect flushed() const { return flushed_; }
  std::size_t flushed_pixels() const { return flushed_pixels_; }
  void forget() { flushed_ = {}, flushed_pixels_ = 0; }

  /// Writes a PPM.
  void save(const std::string& path) const {
    FILE* const file = std::fopen(path.c_str(), "wb");
    ASSERT_NE(file, nullptr) << path;
    std::fprintf(file, "P6 %d %d 255\n", static_cast<int>(width_), static_cast<int>(height_));
    for (std::int32_t y = 0; y < height_; ++y) {
      for (std::int32_t x = 0; x < width_; ++x) {
        const std::uint32_t pixel = rgb565(x, y);
        const std::uint8_t colour[3] = {static_cast<std::uint8_t>((pixel >> 11) * 255 / 31),
                                        static_cast<std::uint8_t>((pixel >> 5 & 63) * 255 / 63),
                                        static_cast<std::uint8_t>((pixel & 31) * 255 / 31)};
        std::fwrite(colour, 1, 3, file);
      }
    }
    std::fclose(file);
  }

 private:
  void take(const lv_area_t& area, const std::uint8_t* from) {
    const Rect rect{area.x1, area.y1, area.x2 + 1, area.y2 + 1};
    flushed_ = flushed_.empty() ? rect
                                : Rect{std::min(flushed_.left, rect.left), std::min(flushed_.top, rect.top),
                                       std::max(flushed_.right, rect.right), std::max(flushed_.bottom, rect.bottom)};
    flushed_pixels_ += static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height());
    if (format_ == LV_COLOR_FORMAT_I1) return;
    // In direct mode the buffer is the whole screen, and only the area in it is new.
    const bool whole = mode_ == LV_DISPLAY_RENDER_MODE_DIRECT;
    const auto row = static_cast<std::size_t>(whole ? width_ : rect.width()) * bytes_;
    const std::uint8_t* const first = whole ? reinterpret_cast<const std::uint8_t*>(buffer_.data()) +
                                                  static_cast<std::size_t>(rect.left) * bytes_ +
                                                  static_cast<std::size_t>(rect.top) * row
                                            : from;
    for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
      std::memcpy(&pixels_[static_cast<std::size_t>(y * width_ + rect.left) * bytes_],
                  first + static_cast<std::size_t>(y - rect.top) * row,
                  static_cast<std::size_t>(rect.width()) * bytes_);
    }
  }

  std::int32_t width_, height_;
  lv_color_format_t format_;
  lv_display_render_mode_t mode_;
  std::size_t bytes_;
  std::vector<std::uint32_t> buffer_;
  std::vector<std::uint8_t> pixels_;
  lv_display_t* display_ = nullptr;
  lv_indev_t* pointer_ = nullptr;
  lv_point_t finger_{};
  bool is_pressed_ = false;
  std::int16_t wheel_ = 0;
  Rect flushed_{};
  std::size_t flushed_pixels_ = 0;
};

}  // namespace zstrip::lvgl_test
