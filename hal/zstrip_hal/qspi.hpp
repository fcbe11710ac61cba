// Panels on QSPI, as AMOLED modules have it: no D/C line; a command is a transfer of an opcode, the command, and its
// parameters on one line; pixels follow theirs on four lines.
//
//   02 00 CC 00   parameters              all on one line; CC is the command
//   32 00 2C 00   pixels                  the pixels on four lines: from the beginning of the window
//   32 00 3C 00   pixels                  from where the pixels before ended
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// The lines of a QSPI with one panel on it.
///   - write(header, data, lines) selects the panel, sends `header` on one line, then `data` on `lines` lines, 1 or 4,
///     and deselects it. `data` may be empty. It may return while data is being sent (DMA): `header` must be copied,
///     `data` stays as it is until wait() returns.
///   - wait() returns when no transfer is under way, with the error of the last one.
/// Both return within a time limit, as those of CommandDataBus. On ESP-IDF: command_bits 8, address_bits 24, and
/// SPI_TRANS_MODE_QIO for four lines.
template <class T>
concept QuadSpi = requires(T& wires, std::span<const std::byte, 4> header, std::span<const std::byte> data,
                           unsigned lines) {
  { wires.write(header, data, lines) } -> std::same_as<Error>;
  { wires.wait() } -> std::same_as<Error>;
};

/// The bus of drivers with MIPI's commands (mipi_dcs.hpp), by QSPI. `wires` must outlive it. Data is pixels only:
/// parameters of a command belong to its transfer. Each write of pixels has whole pixels.
template <QuadSpi Wires>
class QspiBus {
 public:
  /// Sends nothing.
  explicit constexpr QspiBus(Wires& wires) : wires_(wires) {}

  /// Sends a command with its parameters. The command to write pixels is sent with the pixels.
  Error write_whole(std::byte command, std::span<const std::byte> parameters) {
    if (command == kMemoryWrite) {
      next_ = kMemoryWrite;
      return Error::none;
    }
    if (const Error error = wires_.write(header(kOneLine, command), parameters, 1); error != Error::none) return error;
    return wires_.wait();
  }

  /// @{
  /// See the concept CommandDataBus.
  Error write_command(std::span<const std::byte> bytes) {
    return bytes.empty() ? Error::none : write_whole(bytes.front(), bytes.subspan(1));
  }
  Error write_data(std::span<const std::byte> pixels) {
    const std::byte command = next_;
    next_ = kMemoryContinue;
    return wires_.write(header(kFourLines, command), pixels, 4);
  }
  Error wait() { return wires_.wait(); }
  /// @}

 private:
  static constexpr std::byte kOneLine{0x02}, kFourLines{0x32};
  static constexpr std::byte kMemoryWrite{0x2C}, kMemoryContinue{0x3C};

  static constexpr std::array<std::byte, 4> header(std::byte opcode, std::byte command) {
    return {opcode, std::byte{0}, command, std::byte{0}};
  }

  Wires& wires_;
  std::byte next_ = kMemoryWrite;
};

}  // namespace zstrip::hal
