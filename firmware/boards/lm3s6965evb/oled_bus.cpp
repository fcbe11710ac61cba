// Polled SPI to the OLED over SSI0 (PL022).
#include "lm3s6965evb/oled_bus.hpp"

#include <cstdint>

#include "cortex_m/registers.hpp"
#include "lm3s6965evb/chip.hpp"

namespace zstrip::board {
namespace {

using hal::Error;

constexpr std::uint32_t kDataCommandPin = 1U << 7;              // on port C: high for data
constexpr std::uint32_t kClockAndDataPins = 1U << 2 | 1U << 5;  // on port A
constexpr std::uint32_t kPanelSelectPin = 1U << 3;              // on port A, low selects
constexpr std::uint32_t kCardSelectPin = 1U << 0;               // on port D, low selects
constexpr int kPolls = 20'000;                                  // at least five cycles each, at 50 MHz

std::uint32_t status() { return register_at(chip::kSsi0 + chip::kSsiStatus); }

/// Discards received bytes: the receiver runs together with the transmitter. Reads at most as many as the FIFO holds,
/// so that a FIFO which is never empty cannot stop the program.
void drain_receiver() {
  constexpr int kFifo = 8;
  for (int word = 0; word < kFifo && (status() & chip::kSsiReceiveNotEmpty) != 0; ++word) {
    [[maybe_unused]] const std::uint32_t unused = register_at(chip::kSsi0 + chip::kSsiData);
  }
}

/// Waits until the masked status bits have this value.
Error wait_for(std::uint32_t mask, std::uint32_t value) {
  for (int poll = 0; poll < kPolls; ++poll) {
    if ((status() & mask) == value) return Error::none;
  }
  return Error::timeout;
}

/// Waits until the last bit is sent: D/C may change only then.
Error finish() {
  const Error error = wait_for(chip::kSsiBusy, 0);
  drain_receiver();
  return error;
}

Error send(std::uint32_t data_command, std::span<const std::byte> bytes) {
  // A transfer that timed out has left bytes in the transmitter.
  if (const Error error = finish(); error != Error::none) return error;
  register_at(chip::gpio_pins(chip::kGpioC, kDataCommandPin)) = data_command;
  for (const std::byte byte : bytes) {
    if (const Error error = wait_for(chip::kSsiTransmitNotFull, chip::kSsiTransmitNotFull); error != Error::none) {
      return error;
    }
    register_at(chip::kSsi0 + chip::kSsiData) = std::to_integer<std::uint32_t>(byte);
    drain_receiver();
  }
  return finish();
}

void configure_output(std::uint32_t port, std::uint32_t pins, std::uint32_t level) {
  register_at(port + chip::kGpioDirection) = register_at(port + chip::kGpioDirection) | pins;
  register_at(port + chip::kGpioDigital) = register_at(port + chip::kGpioDigital) | pins;
  register_at(chip::gpio_pins(port, pins)) = level;
}

}  // namespace

void OledBus::start() {
  configure_output(chip::kGpioD, kCardSelectPin, kCardSelectPin);
  configure_output(chip::kGpioA, kPanelSelectPin, 0);
  configure_output(chip::kGpioC, kDataCommandPin, 0);
  register_at(chip::kGpioA + chip::kGpioAlternate) =
      register_at(chip::kGpioA + chip::kGpioAlternate) | kClockAndDataPins;
  register_at(chip::kGpioA + chip::kGpioDigital) = register_at(chip::kGpioA + chip::kGpioDigital) | kClockAndDataPins;

  register_at(chip::kSsi0 + chip::kSsiControl1) = 0;   // disabled, and master, during configuration
  register_at(chip::kSsi0 + chip::kSsiPrescale) = 14;  // 50 MHz / 14
  register_at(chip::kSsi0 + chip::kSsiControl0) = 7;   // 8 bits, SPI mode 0
  register_at(chip::kSsi0 + chip::kSsiControl1) = chip::kSsiOn;
}

hal::Error OledBus::write_command(std::span<const std::byte> bytes) { return send(0, bytes); }

hal::Error OledBus::write_data(std::span<const std::byte> bytes) { return send(kDataCommandPin, bytes); }

}  // namespace zstrip::board
