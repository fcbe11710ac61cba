// A panel on SPI through the kernel's driver.
#include "zstrip_hal_linux/spidev.hpp"

#include <linux/spi/spidev.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <vector>

namespace zstrip::hal {
namespace {

/// Returns the largest message that spidev takes, from its module parameter; 4096 bytes by default.
std::size_t most_message_bytes() {
  std::size_t bytes = 0;
  std::ifstream parameter("/sys/module/spidev/parameters/bufsiz");
  return parameter >> bytes && bytes > 0 ? bytes : 4096;
}

/// The kernel reports ETIMEDOUT if the controller does not end a transfer.
Error transfer_error(int error) { return error == ETIMEDOUT ? Error::timeout : Error::bus; }

}  // namespace

Outcome<SpidevBus> SpidevBus::open(const std::string& path, std::uint32_t hertz, GpioPin data_command) {
  Outcome<FileDescriptor> file = open_device(DeviceKind::spi, path);
  if (!file) return file.fault();
  const int number = file->get();
  const auto refused = [&path](const char* doing, int error) {
    return device_fault(DeviceKind::spi, path, doing, error);
  };
  // The device tree sets the polarity of chip select, which stays; this class sets the rest of the mode.
  std::uint8_t mode = 0;
  constexpr std::uint8_t kSelect = SPI_CS_HIGH | SPI_NO_CS;
  if (const int error = device_control(number, SPI_IOC_RD_MODE, &mode); error != 0)
    return refused("tell its mode", error);
  mode &= kSelect;
  std::uint8_t bits = 8;
  if (const int error = device_control(number, SPI_IOC_WR_MODE, &mode); error != 0)
    return refused("be set to mode 0", error);
  if (const int error = device_control(number, SPI_IOC_WR_BITS_PER_WORD, &bits); error != 0)
    return refused("be set to 8 bits", error);
  if (const int error = device_control(number, SPI_IOC_WR_MAX_SPEED_HZ, &hertz); error != 0)
    return refused(("be set to " + std::to_string(hertz) + " Hz").c_str(), error);

  std::uint8_t real_mode = 0;
  std::uint8_t real_bits = 0;
  if (const int error = device_control(number, SPI_IOC_RD_MODE, &real_mode); error != 0)
    return refused("tell its mode", error);
  if (const int error = device_control(number, SPI_IOC_RD_BITS_PER_WORD, &real_bits); error != 0)
    return refused("tell its bits", error);
  if (real_mode != mode || real_bits != 8)
    return Fault{path + " took the setting of mode 0 with 8 bits, but has another one; panels need these"};
  return SpidevBus(std::move(*file), hertz, std::move(data_command));
}

SpidevBus::SpidevBus(FileDescriptor file, std::uint32_t hertz, GpioPin data_command)
    : file_(std::move(file)),
      hertz_(hertz),
      message_bytes_(most_message_bytes()),
      data_command_(std::move(data_command)) {}

Error SpidevBus::write(std::span<const std::byte> bytes, bool data) {
  if (const Error error = data_command_.set(data); error != Error::none) return error;
  while (!bytes.empty()) {
    const std::span<const std::byte> part = bytes.first(std::min(bytes.size(), message_bytes_));
    spi_ioc_transfer transfer{};
    transfer.tx_buf = reinterpret_cast<std::uintptr_t>(part.data());
    transfer.len = static_cast<std::uint32_t>(part.size());
    transfer.speed_hz = hertz_;
    transfer.bits_per_word = 8;
    if (const int error = device_control(file_.get(), SPI_IOC_MESSAGE(1), &transfer); error != 0)
      return transfer_error(error);
    bytes = bytes.subspan(part.size());
  }
  return Error::none;
}

Error SpidevBus::read(std::byte command, unsigned dummy_clocks, std::span<std::byte> answer) {
  if (const Error error = data_command_.set(false); error != Error::none) return error;
  // The kernel counts whole bytes: with dummy bits before the answer, the transfer is one byte longer.
  std::vector<std::byte> arrived(answer.size() + (dummy_clocks != 0 ? 1 : 0));
  std::array<spi_ioc_transfer, 2> transfers{};
  transfers[0].tx_buf = reinterpret_cast<std::uintptr_t>(&command);
  transfers[0].len = 1;
  transfers[1].rx_buf = reinterpret_cast<std::uintptr_t>(arrived.data());
  transfers[1].len = static_cast<std::uint32_t>(arrived.size());
  for (spi_ioc_transfer& transfer : transfers) {
    transfer.speed_hz = std::min(hertz_, kReadHertz);
    transfer.bits_per_word = 8;
  }
  if (const int error = device_control(file_.get(), SPI_IOC_MESSAGE(2), transfers.data()); error != 0)
    return transfer_error(error);
  for (std::size_t i = 0; i < answer.size(); ++i) {
    answer[i] = arrived[i] << dummy_clocks;
    if (dummy_clocks != 0) answer[i] |= arrived[i + 1] >> (8 - dummy_clocks);
  }
  return Error::none;
}

}  // namespace zstrip::hal
