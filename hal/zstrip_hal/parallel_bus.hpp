// The 8080 interface of panels, eight bits wide, write only: eight data lines, a write strobe, D/C, and a select line.
// It is a command/data bus over output pins.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::hal {

/// Eight lines that the processor drives, D7 to D0: set() sets them to the bits of a byte, and returns when the lines
/// have these levels. If they are neighbours in a port, write a class that does it with one or two stores; else use
/// EightPins. Error::pin as in OutputPin.
template <class T>
concept DataLines = std::movable<T> && requires(T& lines, std::uint8_t byte) {
  { lines.set(byte) } -> std::same_as<Error>;
};

/// Any eight pins of one type, D0 first.
template <OutputPin Pin>
class EightPins {
 public:
  /// Pins are copied or moved in.
  explicit constexpr EightPins(std::array<Pin, 8> pins) : pins_(std::move(pins)) {}
  /// Sets one pin after the other, D0 first; stops at the first error.
  Error set(std::uint8_t byte) {
    for (std::size_t i = 0; i < pins_.size(); ++i) {
      if (const Error error = pins_[i].set((byte >> i & 1U) != 0); error != Error::none) return error;
    }
    return Error::none;
  }

 private:
  std::array<Pin, 8> pins_;
};

/// The panel takes data and D/C when the strobe rises. The strobe is low for the duration of one call of its pin, and
/// high for the duration of one call of the data lines: if a call takes less than half of the panel's shortest write
/// cycle, it must wait. The panel's read strobe is wired high. All bytes have been sent when a function returns. An
/// error of a pin is returned; the panel is deselected then, and no byte is half sent.
template <DataLines Lines, OutputPin WritePin, OutputPin DataCommandPin, OutputPin SelectPin = NoPin>
class ParallelBus {
 public:
  /// Pins are copied or moved in.
  constexpr ParallelBus(Lines data, WritePin strobe, DataCommandPin data_command, SelectPin select = {})
      : data_(std::move(data)),
        strobe_(std::move(strobe)),
        data_command_(std::move(data_command)),
        select_(std::move(select)) {}

  /// Sets the lines to their idle levels. Call it once, before any other function.
  Error start() {
    if (const Error error = select_.set(true); error != Error::none) return error;
    if (const Error error = strobe_.set(true); error != Error::none) return error;
    return data_command_.set(false);
  }

  /// @{
  /// See the concept CommandDataBus; all bytes have been sent when the function returns.
  Error write_command(std::span<const std::byte> bytes) { return write(bytes, false); }
  Error write_data(std::span<const std::byte> bytes) { return write(bytes, true); }
  Error wait() { return Error::none; }
  /// @}

 private:
  Error write(std::span<const std::byte> bytes, bool data) {
    // After an error the strobe may be low: raise it while no device is selected.
    Error error = strobe_.set(true);
    if (error == Error::none) error = data_command_.set(data);
    if (error == Error::none) error = select_.set(false);
    for (std::size_t i = 0; error == Error::none && i < bytes.size(); ++i) error = send(bytes[i]);
    const Error deselected = select_.set(true);
    return error != Error::none ? error : deselected;
  }
  Error send(std::byte byte) {
    // Set the data first: if that fails, the strobe is still high, and the panel takes nothing. If the strobe stays
    // low, the select line ends the cycle.
    if (const Error error = data_.set(std::to_integer<std::uint8_t>(byte)); error != Error::none) return error;
    if (const Error error = strobe_.set(false); error != Error::none) return error;
    return strobe_.set(true);
  }

  [[no_unique_address]] Lines data_;
  [[no_unique_address]] WritePin strobe_;
  [[no_unique_address]] DataCommandPin data_command_;
  [[no_unique_address]] SelectPin select_;
};

}  // namespace zstrip::hal
