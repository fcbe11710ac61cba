// zstrip on the display interface of Zephyr 4.4 or later. Drivers have taken the pixels when a call returns, so that
// one strip buffer is enough.
// Needs CONFIG_DISPLAY and a device, as DEVICE_DT_GET(DT_CHOSEN(zephyr_display)). The program calls
// display_blanking_off().
// Format: what the driver reports. PIXEL_FORMAT_RGB_565 is rgb565, PIXEL_FORMAT_RGB_565X is rgb565_swapped. Before 4.4
// the first one had the high byte first, and the second one another name.
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

  /// Once, before the first frame. Error::bus: the device is not ready. Error::configuration: it has other pixels.
  Error start() {
    if (!device_is_ready(display_)) return Error::bus;
    display_get_capabilities(display_, &capabilities_);
    started_ = is(PIXEL_FORMAT_RGB_565) || is(PIXEL_FORMAT_RGB_565X);
    return started_ ? Error::none : Error::configuration;
  }

  /// 0 before start().
  std::uint16_t width() const { return capabilities_.x_resolution; }
  std::uint16_t height() const { return capabilities_.y_resolution; }
  zstrip::hal::PixelFormat format() const {
    using enum zstrip::hal::PixelFormat;
    return is(PIXEL_FORMAT_RGB_565) ? rgb565 : rgb565_swapped;
  }

  Error begin_frame() { return started_ ? Error::none : Error::configuration; }
  Error write(const zstrip::hal::Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    display_buffer_descriptor buffer{};
    buffer.buf_size = bytes_per_row(area.width, format()) * area.height;
    buffer.width = area.width;
    buffer.height = area.height;
    buffer.pitch = area.width;
    buffer.frame_incomplete = area.left + area.width < width() || area.top + area.height < height();
    if (pixels.size() < buffer.buf_size) return Error::pixels_too_small;
    return display_write(display_, area.left, area.top, &buffer, pixels.data()) == 0 ? Error::none : Error::bus;
  }
  Error wait() { return Error::none; }
  Error end_frame() { return Error::none; }

 private:
  bool is(display_pixel_format format) const { return capabilities_.current_pixel_format == format; }

  const struct device* display_;
  display_capabilities capabilities_{};
  bool started_ = false;
};
static_assert(zstrip::hal::Display<ZephyrDisplay>);

}  // namespace adapters
