// Lines that are shared: driven low or left alone, with a resistor that pulls them up, as those of I2C.
#pragma once

#include <concepts>

#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// pull_low() and release() return when the line is driven or left alone; read() gives its level, also while a device
/// drives it. Error::pin where that cannot be done. Pins are handles: what uses one keeps a copy or moves it in.
template <class T>
concept OpenDrainPin = std::movable<T> && requires(T& pin, bool& high) {
  { pin.pull_low() } -> std::same_as<Error>;
  { pin.release() } -> std::same_as<Error>;
  { pin.read(high) } -> std::same_as<Error>;
};

}  // namespace zstrip::hal
