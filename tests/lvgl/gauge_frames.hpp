// The gauge of the package on a display of LVGL, touched like a program of its own would be, and a checksum of all that
// LVGL sends to the display: the same on the host and on a board.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gauge.h"
#include "lvgl.h"
#include "portable/crc32.hpp"

namespace zstrip::lvgl_test {

inline constexpr std::int32_t kGaugeSide = 240;
inline constexpr std::int32_t kGaugeRows = 10;  ///< of LVGL's buffer

/// Sums up the areas and pixels that LVGL sent during a step.
struct Sent {
  std::uint32_t crc32 = 0, pixels = 0;
};

/// Does what happens in a step; the finger is up at its end.
struct GaugeStep {
  const char* name;
  std::int32_t x, y;  ///< where a finger is for 40 ms at the beginning; x < 0: nowhere
  std::uint32_t milliseconds;
};
inline constexpr GaugeStep kGaugeSteps[]{
    {"walk", -1, 0, 300}, {"touched", 120, 110, 100}, {"wave", 205, 218, 100}, {"run", 205, 218, 100}};

/// LVGL with one display in partial mode. One object at a time; it lives as long as LVGL.
class GaugeFrames {
 public:
  static constexpr std::size_t kBufferBytes = 2 * kGaugeSide * kGaugeRows;

  /// Shows the gauge; false after a fault, which LVGL's log names. The buffer's address is a multiple of 4.
  bool show(const lv_zstrip_scene_t& scene, std::span<std::byte, kBufferBytes> buffer) {
    lv_init();
    lv_tick_set_cb([] { return clock_; });
    lv_display_t* const display = lv_display_create(kGaugeSide, kGaugeSide);
    lv_display_set_color_format(display, LV_COLOR_FORMAT_RGB565);
    lv_display_set_buffers(display, buffer.data(), nullptr, kBufferBytes, LV_DISPLAY_RENDER_MODE_PARTIAL);
    lv_display_set_user_data(display, this);
    lv_display_set_flush_cb(display, [](lv_display_t* from, const lv_area_t* area, std::uint8_t* pixels) {
      static_cast<GaugeFrames*>(lv_display_get_user_data(from))->take(*area, pixels);
      lv_display_flush_ready(from);
    });
    lv_indev_t* const pointer = lv_indev_create();
    lv_indev_set_type(pointer, LV_INDEV_TYPE_POINTER);
    lv_indev_set_user_data(pointer, this);
    lv_indev_set_read_cb(pointer, [](lv_indev_t* indev, lv_indev_data_t* data) {
      const auto& frames = *static_cast<const GaugeFrames*>(lv_indev_get_user_data(indev));
      data->point = frames.finger_;
      data->state = frames.is_pressed_ ? LV_INDEV_STATE_PRESSED : LV_INDEV_STATE_RELEASED;
    });
    return show_gauge(lv_screen_active(), &scene);
  }

  Sent run(const GaugeStep& step) {
    crc32_ = board::Crc32();
    pixels_ = 0;
    if (step.x >= 0) {
      finger_ = {step.x, step.y};
      is_pressed_ = true;
      pass(40);
      is_pressed_ = false;
    }
    pass(step.milliseconds);
    return {crc32_.value(), pixels_};
  }

 private:
  void pass(std::uint32_t milliseconds) {
    for (std::uint32_t passed = 0; passed < milliseconds; passed += 5) {
      clock_ += 5;
      lv_timer_handler();
    }
  }
  void take(const lv_area_t& area, const std::uint8_t* pixels) {
    const std::int32_t sides[]{area.x1, area.y1, area.x2, area.y2};
    crc32_.add(std::as_bytes(std::span(sides)));
    const auto count = static_cast<std::uint32_t>(lv_area_get_size(&area));
    crc32_.add(std::as_bytes(std::span(pixels, 2 * std::size_t{count})));
    pixels_ += count;
  }

  static inline std::uint32_t clock_ = 1000;  // LVGL's callback has no context
  board::Crc32 crc32_;
  std::uint32_t pixels_ = 0;
  lv_point_t finger_{};
  bool is_pressed_ = false;
};

}  // namespace zstrip::lvgl_test
