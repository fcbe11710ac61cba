// Converts pixels on their way to the panel, piece by piece: one piece is sent while the next is converted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// Two pieces of 32 bytes, used alternately.
class Piecewise {
 public:
  /// Sends byte_at(0), byte_at(1) ... byte_at(count - 1) as data. No transfer may be under way when it is called. The
  /// last piece may still be under way when it returns: keep the object until the bus's wait().
  template <CommandDataBus Bus, class ByteAt>
  Error send(Bus& bus, std::uint32_t count, ByteAt byte_at) {
    for (std::uint32_t first = 0; first < count; first += kBytes) {
      const std::uint32_t size = count - first < kBytes ? count - first : kBytes;
      std::array<std::byte, kBytes>& piece = pieces_[next_];
      for (std::uint32_t i = 0; i < size; ++i) piece[i] = static_cast<std::byte>(byte_at(first + i));
      if (const Error error = bus.wait(); error != Error::none) return error;
      if (const Error error = bus.write_data(std::span(piece).first(size)); error != Error::none) return error;
      next_ = 1U - next_;
    }
    return Error::none;
  }

 private:
  static constexpr std::uint32_t kBytes = 32;
  std::array<std::array<std::byte, kBytes>, 2> pieces_{};
  std::uint32_t next_ = 0;
};

}  // namespace zstrip::hal
