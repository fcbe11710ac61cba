// Lines of GPIO chips, through libgpiod: D/C, reset, backlight, and the wires of a bit-banged bus.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "zstrip_hal/error.hpp"
#include "zstrip_hal/input_pin.hpp"
#include "zstrip_hal/output_pin.hpp"
#include "zstrip_hal_linux/gpio_backend.hpp"
#include "zstrip_hal_linux/outcome.hpp"

namespace zstrip::hal {

/// A line of a GPIO chip.
struct GpioLine {
  std::string chip;     ///< the path of its device
  unsigned offset = 0;  ///< number of the line in its chip
  friend bool operator==(const GpioLine&, const GpioLine&) = default;
};

/// Returns the paths of all GPIO chips of the machine, in the order of their numbers.
std::vector<std::string> gpio_chips();

/// `text` is CHIP:OFFSET, with the chip as a number, a name (gpiochip0) or a path; or it is the name of a line from
/// the device tree. If several lines have that name, the first one is returned. Errors: no such chip, no permission,
/// no such line.
Outcome<GpioLine> find_gpio_line(const std::string& text);

/// A line that is an output as long as this object lives. Its level afterwards depends on the chip: most keep it. An
/// object that was made without a line is wired to nothing: set() does nothing and succeeds.
class GpioPin {
 public:
  GpioPin() = default;
  /// Starts at `level`. Errors of the chip: it is missing, no permission, no such line, the line is busy (and its
  /// user).
  static Outcome<GpioPin> request(const GpioLine& line, bool level);

  /// Makes no system call if the line already has that level. Error: pin.
  Error set(bool level) {
    if (request_ == nullptr || level == level_) return Error::none;
    if (gpio::set_level(*request_, level) != 0) return Error::pin;
    level_ = level;
    return Error::none;
  }

 private:
  GpioPin(gpio::RequestPointer request, bool level) : request_(std::move(request)), level_(level) {}

  gpio::RequestPointer request_;
  bool level_ = false;
};

static_assert(OutputPin<GpioPin>);

/// A line that is an input as long as this object lives. An object that was made without a line cannot be read.
class GpioInput {
 public:
  GpioInput() = default;
  /// Errors as GpioPin::request().
  static Outcome<GpioInput> request(const GpioLine& line);

  /// Error: pin.
  Error read(bool& high) {
    return request_ != nullptr && gpio::get_level(*request_, high) == 0 ? Error::none : Error::pin;
  }

 private:
  explicit GpioInput(gpio::RequestPointer request) : request_(std::move(request)) {}

  gpio::RequestPointer request_;
};

static_assert(InputPin<GpioInput>);

}  // namespace zstrip::hal
