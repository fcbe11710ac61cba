// Clock tree and pins of the STM32F405/407.
#include "stm32/f4.hpp"

namespace zstrip::board::stm32 {
namespace {

// RCC, 7.3.1 to 7.3.3.
constexpr std::uint32_t kClockControl = 0x40023800;
constexpr std::uint32_t kHseOn = 1U << 16, kHseReady = 1U << 17, kPllOn = 1U << 24, kPllReady = 1U << 25;
constexpr std::uint32_t kPllConfig = 0x40023804;
constexpr std::uint32_t kPllFromHse = 1U << 22;
constexpr std::uint32_t kClockConfig = 0x40023808;
constexpr std::uint32_t kApb1By4 = 5U << 10, kApb2By2 = 4U << 13, kUsePll = 2, kUsesPll = 2U << 2, kUsedMask = 3U << 2;

constexpr std::uint32_t kPowerControl = 0x40007000;  // PWR, 5.4.1
constexpr std::uint32_t kVoltageScale1 = 1U << 14;   // above 144 MHz
constexpr std::uint32_t kFlashAccess = 0x40023C00;   // FLASH, 3.9.1
constexpr std::uint32_t kWaitStates5 = 5, kPrefetch = 1U << 8, kInstructionCache = 1U << 9, kDataCache = 1U << 10;

constexpr ClocksF4 kInternal{16'000'000, 16'000'000, 16'000'000};
constexpr ClocksF4 kFull{168'000'000, 42'000'000, 84'000'000};

bool becomes(std::uint32_t address, std::uint32_t mask, std::uint32_t value) {
  constexpr int kPolls = 100'000;  // the crystal takes some milliseconds at most
  for (int poll = 0; poll < kPolls; ++poll) {
    if ((register_at(address) & mask) == value) return true;
  }
  return false;
}

void set_field(std::uint32_t address, unsigned index, unsigned bits, std::uint32_t value) {
  const std::uint32_t mask = ((1U << bits) - 1U) << (index * bits);
  register_at(address) = (register_at(address) & ~mask) | value << (index * bits);
}

// GPIO, 8.4.
constexpr std::uint32_t kMode = 0x00, kSpeed = 0x08, kAlternateLow = 0x20, kAlternateHigh = 0x24;
constexpr std::uint32_t kOutput = 1, kAlternate = 2, kHighSpeed = 2;  // 50 MHz

/// The oscillator's megahertz by M is 1 MHz; times N = 336, by P = 2. Q = 7 gives USB its 48 MHz.
bool use_crystal(std::uint32_t crystal_megahertz) {
  constexpr std::uint32_t kN = 336U << 6, kPBy2 = 0U << 16, kQ = 7U << 24;
  register_at(kClockControl) = register_at(kClockControl) | kHseOn;
  if (!becomes(kClockControl, kHseReady, kHseReady)) return false;
  enable_clock(kApb1Enable, kApb1Power);
  register_at(kPowerControl) = register_at(kPowerControl) | kVoltageScale1;
  register_at(kPllConfig) = kQ | kPllFromHse | kPBy2 | kN | crystal_megahertz;
  register_at(kClockControl) = register_at(kClockControl) | kPllOn;
  if (!becomes(kClockControl, kPllReady, kPllReady)) return false;
  // The flash must be slow enough before the processor is fast (3.5.1).
  register_at(kFlashAccess) = kWaitStates5 | kPrefetch | kInstructionCache | kDataCache;
  if (!becomes(kFlashAccess, 7, kWaitStates5)) return false;
  register_at(kClockConfig) = kApb1By4 | kApb2By2;
  register_at(kClockConfig) = kApb1By4 | kApb2By2 | kUsePll;
  if (!becomes(kClockConfig, kUsedMask, kUsesPll)) {
    register_at(kClockConfig) = 0;
    return false;
  }
  return true;
}

ClocksF4 clocks_now = kInternal;

}  // namespace

void start_clock_f4(std::uint32_t crystal_megahertz) {
  if (use_crystal(crystal_megahertz)) clocks_now = kFull;
}

const ClocksF4& clocks() { return clocks_now; }

void make_output_f4(char port, unsigned pin) {
  set_field(gpio_f4(port) + kSpeed, pin, 2, kHighSpeed);
  set_field(gpio_f4(port) + kMode, pin, 2, kOutput);
}

void make_alternate_f4(char port, unsigned pin, std::uint32_t function) {
  set_field(gpio_f4(port) + kSpeed, pin, 2, kHighSpeed);
  set_field(gpio_f4(port) + (pin < 8 ? kAlternateLow : kAlternateHigh), pin % 8, 4, function);
  set_field(gpio_f4(port) + kMode, pin, 2, kAlternate);
}

}  // namespace zstrip::board::stm32
