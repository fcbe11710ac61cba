// Sends bytes and discards received ones.
#include "stm32/spi.hpp"

namespace zstrip::board::stm32 {

using hal::Error;

void SpiMaster::start(std::uint32_t divider) {
  at(kSpiControl1) = 0;
  at(kSpiControl2) = 0;
  at(kSpiControl1) = kSpiMaster | kSpiSelectInternal | divider << kSpiDividerShift;
  at(kSpiControl1) = kSpiMaster | kSpiSelectInternal | divider << kSpiDividerShift | kSpiEnable;
}

Error SpiMaster::wait_for(std::uint32_t mask, std::uint32_t value) {
  for (int poll = 0; poll < kPolls; ++poll) {
    const std::uint32_t status = at(kSpiStatus);
    if ((status & mask) == value) return Error::none;
  }
  return Error::timeout;
}

Error SpiMaster::send(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) {
    if (const Error error = wait_for(kSpiTransmitEmpty, kSpiTransmitEmpty); error != Error::none) return error;
    at(kSpiData) = std::to_integer<std::uint32_t>(byte);
  }
  return finish();
}

// RM0090, 28.3.8: waits for the transmit buffer, then for busy. Reading data, then status, clears the overrun.
Error SpiMaster::finish() {
  if (const Error error = wait_for(kSpiTransmitEmpty, kSpiTransmitEmpty); error != Error::none) return error;
  const Error error = wait_for(kSpiBusy, 0);
  [[maybe_unused]] const std::uint32_t received = at(kSpiData);
  [[maybe_unused]] const std::uint32_t status = at(kSpiStatus);
  return error;
}

void SpiMaster::abort() {
  const std::uint32_t control = at(kSpiControl1);
  at(kSpiControl2) = 0;
  at(kSpiControl1) = control & ~kSpiEnable;
  at(kSpiControl1) = control | kSpiEnable;
  [[maybe_unused]] const Error again = finish();  // the caller's error is reported instead
}

}  // namespace zstrip::board::stm32
