// Single lines next to a bus: reset, backlight, D/C, and the lines of a bit-banged bus.
#pragma once

#include <concepts>

#include "zstrip_hal/clock.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// A line that the processor drives. set() sets the electrical level and returns when the line has it, or returns
/// Error::pin if it cannot (a line that belongs to an operating system). On a microcontroller it always succeeds and
/// inlines to a store. Pins are handles: a class that uses one keeps a copy or moves it in.
template <class T>
concept OutputPin = std::movable<T> && requires(T& pin, bool high) {
  { pin.set(high) } -> std::same_as<Error>;
};

/// A placeholder for a line that is not wired, or wired to a fixed level.
struct NoPin {
  /// Does nothing and succeeds.
  constexpr Error set(bool /*high*/) const { return Error::none; }
};
static_assert(OutputPin<NoPin>);

/// Resets a panel by its reset line, which is active low. Call it before the driver's start(), and again if a panel
/// does not answer or shows garbage. Takes 140 ms. The times suit every controller here: the slowest ones need 10 us
/// low, and 120 ms before a command if they were awake (ST7789, ILI9341, ST7735: RESX timing).
template <OutputPin Pin, Clock Time>
Error reset_panel(Pin& reset, Time& clock) {
  if (const Error error = reset.set(true); error != Error::none) return error;
  clock.wait(10'000);  // supplies have settled
  if (const Error error = reset.set(false); error != Error::none) return error;
  clock.wait(10'000);
  if (const Error error = reset.set(true); error != Error::none) return error;
  clock.wait(120'000);
  return Error::none;
}

}  // namespace zstrip::hal
