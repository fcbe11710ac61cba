// Stream 3 of DMA2, channel 3: SPI1_TX (RM0090, 10.3.3, table 43). Registers: RM0090, 10.5.
#include "stm32/dma_panel_bus.hpp"

#include "cortex_m/registers.hpp"

namespace zstrip::board::stm32 {
namespace {

constexpr std::uint32_t kDma2 = 0x40026400;
constexpr std::uint32_t kStatusLow = kDma2 + 0x00, kClearLow = kDma2 + 0x08;
constexpr std::uint32_t kAllFlags = 0x3DU << 22;
constexpr std::uint32_t kFaults = 1U << 24 | 1U << 25;  // direct mode, transfer; the FIFO is not used
constexpr std::uint32_t kComplete = 1U << 27;

constexpr std::uint32_t kStream3 = kDma2 + 0x10 + 3 * 0x18;
constexpr std::uint32_t kConfig = kStream3 + 0x00, kCount = kStream3 + 0x04, kPeripheral = kStream3 + 0x08;
constexpr std::uint32_t kMemory = kStream3 + 0x0C;
constexpr std::uint32_t kEnable = 1U << 0, kFromMemory = 1U << 6, kIncrementMemory = 1U << 10, kChannel3 = 3U << 25;

constexpr std::uint32_t kPollsPerByte = 48;  // at least 6 cycles each; a byte takes 128 at 168 and 10.5 MHz
constexpr std::uint32_t kPollsAtLeast = 20'000;

bool off() {
  for (std::uint32_t poll = 0; poll < kPollsAtLeast; ++poll) {
    if ((register_at(kConfig) & kEnable) == 0) return true;
  }
  return false;
}

}  // namespace

// The order is that of 10.3.17: off, flags cleared, addresses, count, configuration, on.
void SpiDma::start(std::span<const std::byte> bytes) {
  register_at(kConfig) = 0;
  polls_left_ = 0;
  if (!off()) return;  // finish() says so
  register_at(kClearLow) = kAllFlags;
  register_at(kPeripheral) = kSpi1 + kSpiData;
  register_at(kMemory) = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bytes.data()));
  register_at(kCount) = static_cast<std::uint32_t>(bytes.size());
  register_at(kConfig) = kChannel3 | kIncrementMemory | kFromMemory;
  // What was drawn must be in the memory before the stream reads it.
  asm volatile("dsb" ::: "memory");
  register_at(kConfig) = kChannel3 | kIncrementMemory | kFromMemory | kEnable;
  polls_left_ = kPollsAtLeast + kPollsPerByte * static_cast<std::uint32_t>(bytes.size());
}

hal::Error SpiDma::finish() {
  hal::Error error = hal::Error::timeout;
  for (; polls_left_ > 0; --polls_left_) {
    const std::uint32_t status = register_at(kStatusLow);
    if ((status & kFaults) != 0) {
      error = hal::Error::bus;
      break;
    }
    if ((status & kComplete) != 0) {
      error = hal::Error::none;
      break;
    }
  }
  polls_left_ = 0;
  register_at(kConfig) = 0;
  if (!off()) return hal::Error::timeout;
  register_at(kClearLow) = kAllFlags;
  return error;
}

}  // namespace zstrip::board::stm32
