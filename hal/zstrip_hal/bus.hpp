// The interface between a panel's driver and its wires: it sends commands and data. Four-wire SPI tells them apart by
// a D/C line, a parallel bus by an address line, I2C by a control byte. Panel drivers are independent of the method.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// A bus with one panel on it.
///   - write_command() returns when the bytes have arrived: the caller may then reuse them, and switch to data.
///   - write_data() may return while the bytes are still being sent (DMA); they must stay alive and unchanged until
///     wait() returns. Successive writes form one stream of data.
///   - wait() returns when no transfer is under way, with the error of the last write_data(). The caller waits before
///     the next call of either function.
/// Every function returns within a time limit: the driver of a bus states its time-out and returns Error::timeout.
/// Error::bus is a fault that the bus itself reports. After an error the bus is idle and the panel deselected. It is
/// unknown how many of the bytes arrived; the next call starts a new transfer. Use a bus from one thread, or one
/// interrupt level, at a time.
template <class T>
concept CommandDataBus = requires(T& bus, std::span<const std::byte> bytes) {
  { bus.write_command(bytes) } -> std::same_as<Error>;
  { bus.write_data(bytes) } -> std::same_as<Error>;
  { bus.wait() } -> std::same_as<Error>;
};

/// A bus on which the panel can also answer. read() sends a command as write_command() does, lets `dummy_clocks`
/// (0..8) clock cycles pass, and fills `answer`, highest bit first, while the panel stays selected. Call it only when
/// no transfer is under way. `answer` is complete when it returns; after an error its content is undefined. If no wire
/// leads back from the panel, the answer is the idle level of the processor's input: all ones, or all zeros.
template <class T>
concept ReadableBus = CommandDataBus<T> &&
    requires(T& bus, std::byte command, unsigned dummy_clocks, std::span<std::byte> answer) {
  { bus.read(command, dummy_clocks, answer) } -> std::same_as<Error>;
};

}  // namespace zstrip::hal
