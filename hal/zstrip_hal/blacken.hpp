// Zeros for a panel's memory, which holds noise after power-on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// Sends `bytes` zero bytes of data from a constant array of 64, and waits until they are sent.
template <CommandDataBus Bus>
Error send_zeros(Bus& bus, std::uint32_t bytes) {
  static constexpr std::array<std::byte, 64> kZeros{};
  while (bytes != 0) {
    const std::uint32_t part = bytes < kZeros.size() ? bytes : static_cast<std::uint32_t>(kZeros.size());
    if (const Error error = bus.write_data(std::span(kZeros).first(part)); error != Error::none) return error;
    if (const Error error = bus.wait(); error != Error::none) return error;
    bytes -= part;
  }
  return Error::none;
}

}  // namespace zstrip::hal
