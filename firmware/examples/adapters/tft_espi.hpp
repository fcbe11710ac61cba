// zstrip on TFT_eSPI 2.5 of Bodmer, by DMA, which the library has for SPI on ESP32, RP2040 and STM32.
// Needs a User_Setup.h for the panel and an object TFT_eSPI: start() calls its init(), and its initDMA() if the sketch
// has not.
// Format: rgb565_swapped. The library sends the bytes as they lie in memory. A strip has less than 64 KB.
#pragma once

#include <TFT_eSPI.h>
#include <zstrip.h>

namespace adapters {

class TftEspi {
 public:
  using Error = zstrip::hal::Error;
  static constexpr auto kFormat = zstrip::hal::DisplayFormat::rgb565_swapped;

  /// `tft` must outlive it.
  explicit TftEspi(TFT_eSPI& tft) : tft_(tft) {}

  /// Call it once, before setRotation() and the first frame. Error::bus: the library has no DMA here.
  Error start() {
    tft_.init();
    started_ = tft_.DMA_Enabled || tft_.initDMA();  // false where it is enabled already
    return started_ ? Error::none : Error::bus;
  }

  std::uint16_t width() const { return static_cast<std::uint16_t>(tft_.width()); }
  std::uint16_t height() const { return static_cast<std::uint16_t>(tft_.height()); }
  zstrip::hal::DisplayFormat format() const { return kFormat; }

  Error begin_frame() {
    if (!started_) return Error::bus;
    tft_.setSwapBytes(false);  // or the library would swap them in the strip itself
    tft_.startWrite();         // the panel stays selected while a strip is on its way
    return Error::none;
  }
  Error write(const zstrip::hal::Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    if (pixels.size() < bytes_per_row(area.width, kFormat) * area.height) return Error::pixels_too_small;
    // The library does not declare it const, but only reads it if it neither swaps bytes nor clips.
    auto* image = const_cast<std::uint16_t*>(reinterpret_cast<const std::uint16_t*>(pixels.data()));
    tft_.pushImageDMA(area.left, area.top, area.width, area.height, image);
    return Error::none;
  }
  /// The library knows neither errors of a transfer nor a time-out.
  Error wait() {
    tft_.dmaWait();
    return Error::none;
  }
  Error end_frame() {
    tft_.endWrite();
    return Error::none;
  }

 private:
  TFT_eSPI& tft_;
  bool started_ = false;
};
static_assert(zstrip::hal::Display<TftEspi>);

}  // namespace adapters
