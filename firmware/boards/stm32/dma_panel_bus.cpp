// Stream 3 of DMA2, channel 3: SPI1_TX (RM0090, 10.3.3, table 43).
#include "stm32/dma_panel_bus.hpp"

#include "cortex_m/registers.hpp"
#include "stm32/f4_registers.hpp"

namespace zstrip::board::stm32 {
namespace {

constexpr std::uint32_t kPollsPerByte = 48;  // at least 6 cycles each; a byte takes 128 at 160 and 10 MHz
constexpr std::uint32_t kPollsAtLeast = 20'000;

bool off() {
  for (std::uint32_t poll = 0; poll < kPollsAtLeast; ++poll) {
    if ((register_at(kDmaConfig3) & kDmaEnable) == 0) return true;
  }
  return false;
}

}  // namespace

// The order is that of RM0090, 10.3.17: off, flags cleared, addresses, count, configuration, on.
void SpiDma::start(std::span<const std::byte> bytes) {
  register_at(kDmaConfig3) = 0;
  polls_left_ = 0;
  if (!off()) return;  // finish() reports it
  register_at(kDmaClearLow) = kDmaAllFlags3;
  register_at(kDmaPeripheral3) = kSpi1 + kSpiData;
  register_at(kDmaMemory3) = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bytes.data()));
  register_at(kDmaCount3) = static_cast<std::uint32_t>(bytes.size());
  register_at(kDmaConfig3) = kDmaChannel3 | kDmaIncrementMemory | kDmaFromMemory;
  // The drawn pixels must be in the memory before the stream reads it.
  asm volatile("dsb" ::: "memory");
  register_at(kDmaConfig3) = kDmaChannel3 | kDmaIncrementMemory | kDmaFromMemory | kDmaEnable;
  polls_left_ = kPollsAtLeast + kPollsPerByte * static_cast<std::uint32_t>(bytes.size());
}

hal::Error SpiDma::finish() {
  hal::Error error = hal::Error::timeout;
  for (; polls_left_ > 0; --polls_left_) {
    const std::uint32_t status = register_at(kDmaStatusLow);
    if ((status & kDmaFaults3) != 0) {
      error = hal::Error::bus;
      break;
    }
    if ((status & kDmaComplete3) != 0) {
      error = hal::Error::none;
      break;
    }
  }
  polls_left_ = 0;
  register_at(kDmaConfig3) = 0;
  if (!off()) return hal::Error::timeout;
  register_at(kDmaClearLow) = kDmaAllFlags3;
  return error;
}

}  // namespace zstrip::board::stm32
