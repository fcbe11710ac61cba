// SPI0 (PL022) and channel 0 of the DMA.
#include "pico/panel_bus.hpp"

#include "pico/chip.hpp"
#include "pico/pins.hpp"

namespace zstrip::board {
namespace {

using namespace chip;
using hal::Error;

constexpr std::uint32_t kPolls = 20'000;
constexpr std::uint32_t kBitCycles = kHertz / 12'500'000;
constexpr std::uint32_t kPollsPerByte = 32;  // at least 5 cycles each; a byte takes 80 or 96

Error wait_for(std::uint32_t mask, std::uint32_t value) {
  for (std::uint32_t poll = 0; poll < kPolls; ++poll) {
    if ((register_at(kSpi0 + kSpiStatus) & mask) == value) return Error::none;
  }
  return Error::timeout;
}

/// Discards received bytes: the receiver runs together with the transmitter.
void drain_receiver() {
  constexpr int kFifo = 8;
  for (int word = 0; word < kFifo && (register_at(kSpi0 + kSpiStatus) & kSpiReceiveNotEmpty) != 0; ++word) {
    [[maybe_unused]] const std::uint32_t unused = register_at(kSpi0 + kSpiData);
  }
}

// Disabling and enabling the controller empties it.
void configure_spi() {
  register_at(kSpi0 + kSpiControl1) = 0;
  register_at(kSpi0 + kSpiDma) = 0;
  register_at(kSpi0 + kSpiPrescale) = kBitCycles;
  register_at(kSpi0 + kSpiControl0) = 7;  // 8 bits, mode 0
  register_at(kSpi0 + kSpiControl1) = 2;  // on, as master
}

// A channel that has stopped clears the bit (2.5.5.3) and is no longer busy.
bool stop_dma() {
  disable_dma();
  register_at(kDmaAbort) = 1U << 0;
  for (std::uint32_t poll = 0; poll < kPolls; ++poll) {
    if ((register_at(kDmaAbort) & 1U) == 0 && (register_at(kDmaControl) & kDmaBusy) == 0) return true;
  }
  return false;
}

/// Reports only the first error. D/C and select may change only after the last bit is sent.
Error end_transfer(Error error) {
  if (error == Error::none) error = wait_for(kSpiBusy, 0);
  if (error == Error::none) {
    drain_receiver();
    register_at(kSpi0 + kSpiDma) = 0;
  } else {
    configure_spi();
  }
  const Error deselected = PanelSelect().set(true);
  return error != Error::none ? error : deselected;
}

Error begin_transfer(bool data) {
  const Error error = PanelDataCommand().set(data);
  return error != Error::none ? error : PanelSelect().set(false);
}

}  // namespace

void PanelBus::start() {
  constexpr std::uint32_t kSubsystems = kResetSpi0 | kResetDma;
  set_bits(kReset, kSubsystems);
  clear_bits(kReset, kSubsystems);
  for (std::uint32_t poll = 0; poll < kPolls && (register_at(kResetDone) & kSubsystems) != kSubsystems; ++poll) {
  }
  PanelSelect::make_output(true);
  PanelDataCommand::make_output(false);
  PanelReset::make_output(true);
  PanelLight::make_output(false);
  register_at(pin_control(18)) = kFunctionSpi;
  register_at(pin_control(19)) = kFunctionSpi;
  connect_output(18);
  connect_output(19);
  configure_spi();
}

Error PanelBus::write_command(std::span<const std::byte> bytes) {
  Error error = begin_transfer(false);
  for (std::size_t i = 0; error == Error::none && i < bytes.size(); ++i) {
    error = wait_for(kSpiTransmitNotFull, kSpiTransmitNotFull);
    if (error == Error::none) register_at(kSpi0 + kSpiData) = std::to_integer<std::uint32_t>(bytes[i]);
  }
  return end_transfer(error);
}

Error PanelBus::write_data(std::span<const std::byte> bytes) {
  if (const Error error = begin_transfer(true); error != Error::none) return end_transfer(error);
  if (bytes.empty()) return end_transfer(Error::none);
  register_at(kSpi0 + kSpiDma) = kSpiTransmitByDma;
  register_at(kDmaRead) = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bytes.data()));
  register_at(kDmaWrite) = kSpi0 + kSpiData;
  register_at(kDmaCount) = static_cast<std::uint32_t>(bytes.size());
  // Drawn pixels must be in memory before the channel reads them. A channel that chains to itself does not chain.
  finish_writes();
  register_at(kDmaControl) =
      kDmaFaults | kDmaAtSpi0Pace | kDmaIncrementRead | kDmaEnable;  // writing ones clears the faults
  polls_left_ = kPolls + kPollsPerByte * static_cast<std::uint32_t>(bytes.size());
  sending_ = true;
  return Error::none;
}

Error PanelBus::wait() {
  if (!sending_) return Error::none;
  sending_ = false;
  Error error = Error::timeout;
  for (; polls_left_ > 0; --polls_left_) {
    const std::uint32_t control = register_at(kDmaControl);
    if ((control & kDmaFaults) != 0) {
      error = Error::bus;
      break;
    }
    if ((control & kDmaBusy) == 0) {
      error = Error::none;
      break;
    }
  }
  if (error != Error::none && !stop_dma()) error = Error::timeout;
  return end_transfer(error);
}

}  // namespace zstrip::board
