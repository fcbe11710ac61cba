// SPI without a controller: a command/data bus over three output pins, an optional fourth that selects the panel, and
// an optional input for the panel's answers. For processors whose SPI is in use or wired elsewhere. It is slow, and
// the processor is busy until a transfer ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/input_pin.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::hal {

/// SPI mode 0, highest bit first: the panel takes data and D/C at the rising edge of the clock. Only one call of a pin
/// lies between two edges. If that call takes less than half of the panel's shortest clock cycle, set() of the pin
/// must wait. All bytes have been sent when a function returns. An error of a pin is returned; the panel is deselected
/// then, so that a panel with a select line discards the bits of an incomplete byte. With an input pin for the panel's
/// answers the class is a ReadableBus: the panel outputs a bit at a falling edge, and it is read before the next
/// rising edge.
template <OutputPin ClockPin, OutputPin DataPin, OutputPin DataCommandPin, OutputPin SelectPin = NoPin,
          class AnswerPin = NoPin>
class BitBangedSpi {
 public:
  /// Pins are copied or moved in.
  constexpr BitBangedSpi(ClockPin clock, DataPin data, DataCommandPin data_command, SelectPin select = {},
                         AnswerPin answer = {})
      : clock_(std::move(clock)),
        data_(std::move(data)),
        data_command_(std::move(data_command)),
        select_(std::move(select)),
        answer_(std::move(answer)) {}

  /// Sets the lines to their idle levels. Call it once, before any other function.
  Error start() {
    if (const Error error = select_.set(true); error != Error::none) return error;
    if (const Error error = clock_.set(false); error != Error::none) return error;
    return data_command_.set(false);
  }

  /// @{
  /// See the concept CommandDataBus; all bytes have been sent when the function returns.
  Error write_command(std::span<const std::byte> bytes) { return write(bytes, false); }
  Error write_data(std::span<const std::byte> bytes) { return write(bytes, true); }
  Error wait() { return Error::none; }
  /// @}

  /// See ReadableBus.
  Error read(std::byte command, unsigned dummy_clocks, std::span<std::byte> answer) requires InputPin<AnswerPin> {
    Error error = data_command_.set(false);
    if (error == Error::none) error = select_.set(false);
    if (error == Error::none) error = send(std::to_integer<std::uint32_t>(command));
    if (error == Error::none) error = data_command_.set(true);
    bool bit = false;
    for (unsigned i = 0; error == Error::none && i < dummy_clocks; ++i) error = take(bit);
    for (std::size_t i = 0; error == Error::none && i < 8 * answer.size(); ++i) {
      error = take(bit);
      answer[i / 8] = (answer[i / 8] << 1) | static_cast<std::byte>(bit ? 1 : 0);
    }
    return ended(error);
  }

 private:
  Error write(std::span<const std::byte> bytes, bool data) {
    Error error = data_command_.set(data);
    if (error == Error::none) error = select_.set(false);
    for (std::size_t i = 0; error == Error::none && i < bytes.size(); ++i) {
      error = send(std::to_integer<std::uint32_t>(bytes[i]));
    }
    return ended(error);
  }
  /// Ends a transfer: sets the lines to their idle levels, also after an error.
  Error ended(Error error) {
    const Error idle = clock_.set(false);
    const Error deselected = select_.set(true);
    if (error != Error::none) return error;
    return idle != Error::none ? idle : deselected;
  }
  Error send(std::uint32_t byte) {
    for (int bit = 7; bit >= 0; --bit) {
      if (const Error error = clock_.set(false); error != Error::none) return error;
      if (const Error error = data_.set(((byte >> bit) & 1U) != 0); error != Error::none) return error;
      if (const Error error = clock_.set(true); error != Error::none) return error;
    }
    return Error::none;
  }

  Error take(bool& bit) requires InputPin<AnswerPin> {
    if (const Error error = clock_.set(false); error != Error::none) return error;
    if (const Error error = answer_.read(bit); error != Error::none) return error;
    return clock_.set(true);
  }

  [[no_unique_address]] ClockPin clock_;
  [[no_unique_address]] DataPin data_;
  [[no_unique_address]] DataCommandPin data_command_;
  [[no_unique_address]] SelectPin select_;
  [[no_unique_address]] AnswerPin answer_;
};

}  // namespace zstrip::hal
