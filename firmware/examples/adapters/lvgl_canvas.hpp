// zstrip in a canvas of LVGL 9: the scene is a widget among others. Strips are copied, without DMA.
// Needs LV_USE_CANVAS and a canvas with a buffer (LV_DRAW_BUF_DEFINE_STATIC and lv_canvas_set_draw_buf(), or
// lv_canvas_set_buffer()) of LV_COLOR_FORMAT_RGB565. Frames are drawn where LVGL may be called: in its thread, or
// between lv_lock() and lv_unlock().
// Format: rgb565. LVGL's colours are words of the processor, the low byte first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include <lvgl.h>
#include <zstrip_hal/display.hpp>

namespace adapters {

class LvglCanvas {
 public:
  using Error = zstrip::hal::Error;
  static constexpr auto kFormat = zstrip::hal::DisplayFormat::rgb565;

  /// Must end before the canvas is deleted.
  explicit LvglCanvas(lv_obj_t* canvas) : canvas_(canvas) {}

  /// 0 while the canvas has no buffer.
  std::uint16_t width() const { return buffer() != nullptr ? static_cast<std::uint16_t>(buffer()->header.w) : 0; }
  std::uint16_t height() const { return buffer() != nullptr ? static_cast<std::uint16_t>(buffer()->header.h) : 0; }
  zstrip::hal::DisplayFormat format() const { return kFormat; }

  /// Error::framebuffer: the canvas has no buffer, or one of another format.
  Error begin_frame() {
    const bool fits = buffer() != nullptr && buffer()->header.cf == LV_COLOR_FORMAT_RGB565;
    return fits ? Error::none : Error::framebuffer;
  }
  Error write(const zstrip::hal::Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    const std::uint32_t row_bytes = bytes_per_row(area.width, kFormat);
    if (pixels.size() < row_bytes * area.height) return Error::pixels_too_small;
    for (std::uint32_t row = 0; row < area.height; ++row) {
      void* to = lv_draw_buf_goto_xy(buffer(), area.left, area.top + row);
      std::memcpy(to, &pixels[row * row_bytes], row_bytes);
    }
    return Error::none;
  }
  Error wait() { return Error::none; }
  Error end_frame() {
    lv_obj_invalidate(canvas_);
    return Error::none;
  }

 private:
  lv_draw_buf_t* buffer() const { return lv_canvas_get_draw_buf(canvas_); }

  lv_obj_t* canvas_;
};
static_assert(zstrip::hal::Display<LvglCanvas>);

}  // namespace adapters
