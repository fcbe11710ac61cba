// A driver of spidev that is not there, and perhaps a panel that answers.
#pragma once

#include <linux/spi/spidev.h>

#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "panel/panel_model.hpp"

namespace zstrip::linux_mock {

/// What it was set to, and what arrived.
struct MockedSpi {
  std::uint8_t mode = 0, bits = 0;
  std::uint32_t hertz = 0;
  bool keeps_mode = false;  ///< says yes and changes nothing
  unsigned long refused = 0;
  int error = EINVAL;
  int messages_until_failure = -1, failure = EIO;
  std::vector<std::vector<std::uint8_t>> messages;
  sim::PanelModel* panel = nullptr;  ///< that answers; or nobody, and the line has the level of `floating`
  int floating = 0xFF;
  std::uint32_t read_hertz = 0;

  /// A command, and as many bytes as the panel has to give, while it stays selected.
  int answer(const spi_ioc_transfer* transfers) {
    const spi_ioc_transfer &command = transfers[0], &reading = transfers[1];
    if (command.len != 1 || command.rx_buf != 0 || command.cs_change != 0 || reading.tx_buf != 0) return EINVAL;
    if (messages_until_failure-- == 0) return failure;
    read_hertz = reading.speed_hz;
    auto* bytes = reinterpret_cast<std::uint8_t*>(reading.rx_buf);
    std::memset(bytes, floating, reading.len);
    if (panel == nullptr) return 0;
    const auto code = *reinterpret_cast<const std::uint8_t*>(command.tx_buf);
    const std::vector<bool> levels = panel->ask(code, std::size_t{8} * reading.len, sim::Nanoseconds(500));
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const unsigned mask = 0x80U >> (i % 8);
      bytes[i / 8] = static_cast<std::uint8_t>(levels[i] ? bytes[i / 8] | mask : bytes[i / 8] & ~mask);
    }
    return 0;
  }

  int control(unsigned long request, void* argument) {
    if (request == refused) return error;
    switch (request) {
      case SPI_IOC_RD_MODE: std::memcpy(argument, &mode, sizeof mode); return 0;
      case SPI_IOC_WR_MODE:
        if (!keeps_mode) std::memcpy(&mode, argument, sizeof mode);
        return 0;
      case SPI_IOC_RD_BITS_PER_WORD: std::memcpy(argument, &bits, sizeof bits); return 0;
      case SPI_IOC_WR_BITS_PER_WORD: std::memcpy(&bits, argument, sizeof bits); return 0;
      case SPI_IOC_WR_MAX_SPEED_HZ: std::memcpy(&hertz, argument, sizeof hertz); return 0;
      case SPI_IOC_MESSAGE(1): break;
      case SPI_IOC_MESSAGE(2): return answer(static_cast<const spi_ioc_transfer*>(argument));
      default: return ENOTTY;
    }
    spi_ioc_transfer transfer{};
    std::memcpy(&transfer, argument, sizeof transfer);
    if (transfer.len > 4096) return EMSGSIZE;
    if (messages_until_failure-- == 0) return failure;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(transfer.tx_buf);
    messages.emplace_back(bytes, bytes + transfer.len);
    return 0;
  }
};

}  // namespace zstrip::linux_mock
