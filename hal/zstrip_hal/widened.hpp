// Widens pixels of 16 bits to the three bytes that some panels want, on their way, in pieces: one is sent while the
// next is made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// Two pieces of 16 pixels, used alternately: 96 bytes.
class Widened {
 public:
  /// Sends pixels of rgb565_swapped as rgb666. Red and blue repeat their highest bit, so that white stays white. No
  /// transfer may be under way when it is called. The last piece may still be under way when it returns: keep the
  /// object until the bus's wait().
  template <CommandDataBus Bus>
  Error send(Bus& bus, std::span<const std::byte> pixels) {
    while (!pixels.empty()) {
      const std::size_t size = pixels.size() < 2 * kPixels ? pixels.size() : 2 * kPixels;
      std::array<std::byte, 3 * kPixels>& piece = pieces_[next_];
      std::byte* to = piece.data();
      for (std::size_t i = 0; i < size; i += 2, to += 3) {
        const std::uint32_t pixel =
            std::to_integer<std::uint32_t>(pixels[i]) << 8 | std::to_integer<std::uint32_t>(pixels[i + 1]);
        to[0] = static_cast<std::byte>(five_to_six(pixel >> 11));
        to[1] = static_cast<std::byte>(pixel >> 3 & 0xFCU);
        to[2] = static_cast<std::byte>(five_to_six(pixel & 0x1FU));
      }
      if (const Error error = bus.wait(); error != Error::none) return error;
      if (const Error error = bus.write_data(std::span(piece).first(size / 2 * 3)); error != Error::none) return error;
      next_ = 1U - next_;
      pixels = pixels.subspan(size);
    }
    return Error::none;
  }

 private:
  static constexpr std::size_t kPixels = 16;
  /// Returns six bits in the upper bits of a byte.
  static constexpr std::uint32_t five_to_six(std::uint32_t channel) { return channel << 3 | (channel >> 2 & 0x04U); }

  std::array<std::array<std::byte, 3 * kPixels>, 2> pieces_{};
  std::uint32_t next_ = 0;
};

}  // namespace zstrip::hal
