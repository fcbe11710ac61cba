// zstrip on the display interface of Zephyr. Drivers have taken the pixels when a call returns, so that
// one strip buffer is enough.
// Needs CONFIG_DISPLAY and a device, as DEVICE_DT_GET(DT_CHOSEN(zephyr_display)). The program calls
// display_blanking_off(). Some drivers (SDL, electronic paper) show a frame when its last corner is written: with
// ChangedTiles, which writes what has changed, they may show it late.
// Format: what the driver reports. From Zephyr 4.4 on PIXEL_FORMAT_RGB_565 is rgb565, PIXEL_FORMAT_RGB_565X is
// rgb565_swapped. Up to 4.2 PIXEL_FORMAT_RGB_565 has the high byte first, rgb565_swapped, and PIXEL_FORMAT_BGR_565 is
// rgb565. In 4.3 drivers differ, and in any release one may report the wrong order: where black and white are right and
// all other colours are wrong, the constructor's second argument is the other format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <zephyr/device.h>
#include <zephyr/drivers/display.h>
#include <zstrip_hal/display.hpp>

namespace adapters {

class ZephyrDisplay {
 public:
  using Error = zstrip::hal::Error;

  explicit ZephyrDisplay(const struct device* display) : display_(display) {}
  /// `format`: rgb565 or rgb565_swapped, whichever of the two formats with 16 bits the driver reports.
  ZephyrDisplay(const struct device* display, zstrip::hal::DisplayFormat format)
      : display_(display), low_(format), high_(format) {}

  /// Call it once, before the first frame. Error::bus: the device is not ready. Error::configuration: it has other
  /// pixels.
  Error start() {
    if (!device_is_ready(display_)) return Error::bus;
    display_get_capabilities(display_, &capabilities_);
    started_ = is(kLowFirst) || is(kHighFirst);
    return started_ ? Error::none : Error::configuration;
  }

  /// 0 before start().
  std::uint16_t width() const { return capabilities_.x_resolution; }
  std::uint16_t height() const { return capabilities_.y_resolution; }
  zstrip::hal::DisplayFormat format() const { return is(kLowFirst) ? low_ : high_; }

  Error begin_frame() { return started_ ? Error::none : Error::configuration; }
  Error write(const zstrip::hal::Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    display_buffer_descriptor buffer{};
    buffer.buf_size = bytes_per_row(area.width, format()) * area.height;
    buffer.width = area.width;
    buffer.height = area.height;
    buffer.pitch = area.width;
    set_incomplete(buffer, area.left + area.width < width() || area.top + area.height < height());
    if (pixels.size() < buffer.buf_size) return Error::pixels_too_small;
    return display_write(display_, area.left, area.top, &buffer, pixels.data()) == 0 ? Error::none : Error::bus;
  }
  Error wait() { return Error::none; }
  Error end_frame() { return Error::none; }

 private:
#ifdef PANEL_PIXEL_FORMAT_RGB_565X
  static constexpr auto kLowFirst = PIXEL_FORMAT_RGB_565, kHighFirst = PIXEL_FORMAT_RGB_565X;
#else
  static constexpr auto kLowFirst = PIXEL_FORMAT_BGR_565, kHighFirst = PIXEL_FORMAT_RGB_565;
#endif

  /// Older releases have no such member: their drivers show each strip at once.
  template <typename Buffer>
  static void set_incomplete(Buffer& buffer, bool incomplete) {
    if constexpr (requires { buffer.frame_incomplete; }) buffer.frame_incomplete = incomplete;
  }
  bool is(display_pixel_format format) const { return capabilities_.current_pixel_format == format; }

  const struct device* display_;
  zstrip::hal::DisplayFormat low_ = zstrip::hal::DisplayFormat::rgb565,
                             high_ = zstrip::hal::DisplayFormat::rgb565_swapped;
  display_capabilities capabilities_{};
  bool started_ = false;
};
static_assert(zstrip::hal::Display<ZephyrDisplay>);

}  // namespace adapters
