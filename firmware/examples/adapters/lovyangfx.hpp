// zstrip on LovyanGFX 1.2 or M5GFX, by DMA where the library has it for the bus. With M5GFX, its M5GFX.h or M5Unified.h
// is included before this file: the Arduino IDE finds libraries by what a sketch includes. Needs a class for the board,
// derived from lgfx::LGFX_Device, with 16 bits a pixel: M5GFX, or a class LGFX of yours. start() calls its init().
// Format: rgb565_swapped, the library's swap565_t, which it sends without converting it.
#pragma once

#include <zstrip.h>
#if __has_include(<M5GFX.h>) && (defined(__M5GFX_H__) || !__has_include(<LovyanGFX.hpp>))
#include <M5GFX.h>
#else
#include <LovyanGFX.hpp>
#endif

namespace adapters {

class LovyanGfx {
 public:
  using Error = zstrip::hal::Error;
  static constexpr auto kFormat = zstrip::hal::DisplayFormat::rgb565_swapped;

  /// `device` must outlive it.
  explicit LovyanGfx(lgfx::LGFX_Device& device) : device_(device) {}

  /// Once, before setRotation() and the first frame. Error::bus: the library finds no panel.
  Error start() {
    started_ = device_.init();
    if (started_) device_.initDMA();
    return started_ ? Error::none : Error::bus;
  }

  std::uint16_t width() const { return static_cast<std::uint16_t>(device_.width()); }
  std::uint16_t height() const { return static_cast<std::uint16_t>(device_.height()); }
  zstrip::hal::DisplayFormat format() const { return kFormat; }

  Error begin_frame() {
    if (!started_) return Error::bus;
    device_.startWrite();  // without it the library ends each transfer before it returns
    return Error::none;
  }
  Error write(const zstrip::hal::Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    if (pixels.size() < bytes_per_row(area.width, kFormat) * area.height) return Error::pixels_too_small;
    const auto* image = reinterpret_cast<const lgfx::swap565_t*>(pixels.data());
    device_.pushImageDMA(area.left, area.top, area.width, area.height, image);
    return Error::none;
  }
  /// The library knows neither errors of a transfer nor a time-out.
  Error wait() {
    device_.waitDMA();
    return Error::none;
  }
  Error end_frame() {
    device_.endWrite();
    return Error::none;
  }

 private:
  lgfx::LGFX_Device& device_;
  bool started_ = false;
};
static_assert(zstrip::hal::Display<LovyanGfx>);

}  // namespace adapters
