// SPI without a controller: a command/data bus over three output pins, a fourth to select the panel, and an input on
// which it answers. For processors whose SPI is in use or wired elsewhere; slow, and the processor does nothing else
// meanwhile.
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

/// SPI mode 0, highest bit first: the panel takes data and D/C at the clock's rising edge. Between two edges lies one
/// call of a pin and nothing else: where a pin takes less than half of the panel's shortest clock cycle, its set() must
/// wait. Everything has been sent when a function returns. Errors are the pins'; the panel is deselected then, so that
/// the bits of an incomplete byte are forgotten, where it has a select line. With an input pin for the panel's answers
/// it is a ReadableBus: the panel gives a bit at a falling edge, it is read before the next rising one.
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

  /// Gives the lines their idle levels. To be called once, before anything else.
  Error start() {
    if (const Error error = select_.set(true); error != Error::none) return error;
    if (const Error error = clock_.set(false); error != Error::none) return error;
    return data_command_.set(false);
  }

  /// @{
  /// As the concept CommandDataBus states; everything has been sent when it returns.
  Error write_command(std::span<const std::byte> bytes) { return write(bytes, false); }
  Error write_data(std::span<const std::byte> bytes) { return write(bytes, true); }
  Error wait() { return Error::none; }
  /// @}

  /// As ReadableBus states.
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
  /// The end of a transfer: the lines rest, whatever happened.
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
