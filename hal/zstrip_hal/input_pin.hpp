// Lines that the processor only reads: the panel's answers on a bit-banged bus.
#pragma once

#include <concepts>

#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// read() returns the electrical level in `high`, or Error::pin if it cannot read. Pins are handles: a class that uses
/// one keeps a copy or moves it in.
template <class T>
concept InputPin = std::movable<T> && requires(T& pin, bool& high) {
  { pin.read(high) } -> std::same_as<Error>;
};

}  // namespace zstrip::hal
