// Single lines beside a bus: reset, backlight, D/C, and those of a bit-banged bus.
#pragma once

#include <concepts>

#include "zstrip_hal/clock.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// A line that the processor drives. set() gives the electrical level and returns when the line has it; Error::pin
/// where it cannot (a line that belongs to an operating system). On a microcontroller it always succeeds and inlines to
/// a store. Pins are handles: what uses one keeps a copy or moves it in.
template <class T>
concept OutputPin = std::movable<T> && requires(T& pin, bool high) {
  { pin.set(high) } -> std::same_as<Error>;
};

/// Stands for a line that is not wired, or wired to a fixed level.
struct NoPin {
  /// Nothing happens.
  constexpr Error set(bool /*high*/) const { return Error::none; }
};
static_assert(OutputPin<NoPin>);

/// Resets a panel by its reset line, which is low while active: before the driver's start(), and again where a panel
/// does not answer or shows garbage. Takes 140 ms. The times suit every controller here: the longest need 10 us
/// low, and for 120 ms until a command if it was awake (ST7789, ILI9341, ST7735: RESX timing).
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
