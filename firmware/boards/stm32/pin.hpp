// A pin of an STM32 that is an output. Sources: RM0041, 7.2.5 and RM0090, 8.4.7 (bit set/reset register).
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::board {

/// `set_reset` is the address of the port's register. Setting is one store, so that other code may change other pins of
/// the port meanwhile.
template <std::uint32_t set_reset, unsigned number>
struct Pin {
  static_assert(number < 16);
  hal::Error set(bool high) const {
    register_at(set_reset) = 1U << (high ? number : number + 16);
    return hal::Error::none;
  }
};

}  // namespace zstrip::board
