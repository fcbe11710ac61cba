// Shared lines with a pull-up resistor, such as the lines of I2C: a device pulls the line low or releases it.
#pragma once

#include <concepts>

#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// pull_low() and release() return when the line is driven low or released. read() returns the level in `high`, also
/// while another device drives the line. All return Error::pin if they cannot. Pins are handles: a class that uses one
/// keeps a copy or moves it in.
template <class T>
concept OpenDrainPin = std::movable<T> && requires(T& pin, bool& high) {
  { pin.pull_low() } -> std::same_as<Error>;
  { pin.release() } -> std::same_as<Error>;
  { pin.read(high) } -> std::same_as<Error>;
};

}  // namespace zstrip::hal
