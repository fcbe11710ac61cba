// What a panel's driver needs of the wires: commands and data, told apart. Four-wire SPI has a D/C line for it,
// a parallel bus an address line, I2C a control byte; drivers of panels do not see which.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// A bus with one panel on it.
///   - write_command() returns when the bytes have arrived: the caller may reuse them, and switch to data.
///   - write_data() may return while the bytes are still being sent (DMA); they must stay alive and unchanged until
///     wait() returns. Bytes of successive writes follow each other without a gap in meaning.
///   - wait() returns when nothing is under way, with the error of the last write_data(). The caller waits before the
///     next call of either function.
/// No function blocks for ever: a driver of a bus states its time-out and returns Error::timeout. Error::bus is a fault
/// that the bus itself reports. After an error the bus is idle and the panel deselected: how much of the bytes arrived
/// is unknown, the next call starts a transfer of its own. One thread, or one interrupt level, at a time.
template <class T>
concept CommandDataBus = requires(T& bus, std::span<const std::byte> bytes) {
  { bus.write_command(bytes) } -> std::same_as<Error>;
  { bus.write_data(bytes) } -> std::same_as<Error>;
  { bus.wait() } -> std::same_as<Error>;
};

/// A bus on which the panel answers, too. read() sends a command as write_command() does, lets `dummy_clocks` (0..8)
/// cycles of the clock pass, and takes all bytes of `answer`, highest bit first, while the panel stays selected;
/// nothing may be under way. It has them when it returns; after an error they mean nothing. Where no wire comes back
/// from the panel the answer is what the processor's input rests at: all ones, or all zeros.
template <class T>
concept ReadableBus = CommandDataBus<T> &&
    requires(T& bus, std::byte command, unsigned dummy_clocks, std::span<std::byte> answer) {
  { bus.read(command, dummy_clocks, answer) } -> std::same_as<Error>;
};

}  // namespace zstrip::hal
