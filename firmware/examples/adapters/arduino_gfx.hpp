// zstrip on Arduino_GFX 1.4 or later ("GFX Library for Arduino" of moononournation). Its buses have sent the pixels
// when a call returns, also those that use DMA, so that one strip buffer is enough.
// Needs an object of a panel's class, or an Arduino_Canvas, that was not started: start() calls its begin().
// Format: rgb565_swapped, which the library calls big endian.
#pragma once

#include <Arduino_GFX_Library.h>
#include <zstrip.h>

namespace adapters {

class ArduinoGfx {
 public:
  using Error = zstrip::hal::Error;
  static constexpr auto kFormat = zstrip::hal::DisplayFormat::rgb565_swapped;

  /// `gfx` must outlive it.
  explicit ArduinoGfx(Arduino_GFX& gfx) : gfx_(gfx) {}

  /// Once, before setRotation() and the first frame. Error::bus: the library cannot start the bus.
  Error start() {
    started_ = gfx_.begin();
    return started_ ? Error::none : Error::bus;
  }

  std::uint16_t width() const { return static_cast<std::uint16_t>(gfx_.width()); }
  std::uint16_t height() const { return static_cast<std::uint16_t>(gfx_.height()); }
  zstrip::hal::DisplayFormat format() const { return kFormat; }

  Error begin_frame() { return started_ ? Error::none : Error::bus; }
  Error write(const zstrip::hal::Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    if (pixels.size() < bytes_per_row(area.width, kFormat) * area.height) return Error::pixels_too_small;
    // The library does not declare it const, but only reads it.
    auto* image = const_cast<std::uint16_t*>(reinterpret_cast<const std::uint16_t*>(pixels.data()));
    const auto number = [](std::uint16_t value) { return static_cast<std::int16_t>(value); };
    gfx_.draw16bitBeRGBBitmap(number(area.left), number(area.top), image, number(area.width), number(area.height));
    return Error::none;
  }
  Error wait() { return Error::none; }
  Error end_frame() {
    gfx_.flush();  // a canvas goes to its panel now; others do nothing
    return Error::none;
  }

 private:
  Arduino_GFX& gfx_;
  bool started_ = false;
};
static_assert(zstrip::hal::Display<ArduinoGfx>);

}  // namespace adapters
