// Clock tree and pins of the STM32F405/407.
#include "stm32/f4.hpp"

namespace zstrip::board::stm32 {
namespace {

constexpr ClocksF4 kInternal{16'000'000, 16'000'000, 16'000'000};
constexpr ClocksF4 kFull{160'000'000, 40'000'000, 80'000'000};

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

/// The crystal's megahertz divided by M is 1 MHz; times N = 320, divided by P = 2. Not the 168 MHz that the chip
/// allows, because no divider makes 10 MHz for an ILI9341 from it. Q is for USB, which is unused: its output must not
/// exceed 48 MHz.
bool use_crystal(std::uint32_t crystal_megahertz) {
  constexpr std::uint32_t kN = 320U << kPllNShift, kPBy2 = 0U << kPllPShift, kQ = 7U << kPllQShift;
  register_at(kClockControl) = register_at(kClockControl) | kHseOn;
  if (!becomes(kClockControl, kHseReady, kHseReady)) return false;
  enable_clock(kApb1Enable, kApb1Power);
  register_at(kPowerControl) = register_at(kPowerControl) | kVoltageScale1;
  register_at(kPllConfig) =
      (register_at(kPllConfig) & kPllReserved) | kQ | kPllFromHse | kPBy2 | kN | crystal_megahertz;
  register_at(kClockControl) = register_at(kClockControl) | kPllOn;
  if (!becomes(kClockControl, kPllReady, kPllReady)) return false;
  // The flash's wait states must be set before the processor becomes fast (3.5.1).
  register_at(kFlashAccess) = kWaitStates5 | kPrefetch | kInstructionCache | kDataCache;
  if (!becomes(kFlashAccess, kWaitStatesMask, kWaitStates5)) return false;
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
  set_field(gpio_f4(port) + kGpioSpeed, pin, 2, kGpioHighSpeed);
  set_field(gpio_f4(port) + kGpioMode, pin, 2, kGpioOutput);
}

void make_alternate_f4(char port, unsigned pin, std::uint32_t function) {
  set_field(gpio_f4(port) + kGpioSpeed, pin, 2, kGpioHighSpeed);
  set_field(gpio_f4(port) + (pin < 8 ? kGpioAlternateLow : kGpioAlternateHigh), pin % 8, 4, function);
  set_field(gpio_f4(port) + kGpioMode, pin, 2, kGpioAlternate);
}

}  // namespace zstrip::board::stm32
