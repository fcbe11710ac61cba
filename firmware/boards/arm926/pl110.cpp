// Sets the PL110 up. Sources: PrimeCell Color LCD Controller (PL110) technical reference manual, chapter 3; Versatile
// Application Baseboard for ARM926EJ-S user guide, sections 3.5 and 4.3, for the board's own multiplexer.
#include "arm926/pl110.hpp"

#include "cortex_m/registers.hpp"

namespace zstrip::board {
namespace {

constexpr std::uint32_t kSystem = 0x10000000;
constexpr std::uint32_t kSystemLock = 0x20;
constexpr std::uint32_t kUnlock = 0xA05F;
constexpr std::uint32_t kSystemLcd = 0x50;
constexpr std::uint32_t kBlueInLowBits565 = 3;  // the layout in which the board's multiplexer reads 16 bits

constexpr std::uint32_t kLcd = 0x10120000;
constexpr std::uint32_t kTiming0 = 0x00, kTiming1 = 0x04, kTiming2 = 0x08;
constexpr std::uint32_t kUpperBase = 0x10;
constexpr std::uint32_t kControl = 0x18;  // on this board; in the manual 0x1C
constexpr std::uint32_t kBypassDivider = 1U << 26;
constexpr std::uint32_t kEnable = 1U << 0, kSixteenBits = 4U << 1, kTft = 1U << 5, kPower = 1U << 11;

}  // namespace

void start_lcd(const LcdMode& mode, const std::byte* pixels) {
  const auto& [columns, columns_sync, columns_front, columns_back] = mode.horizontal;
  const auto& [lines, lines_sync, lines_front, lines_back] = mode.vertical;
  register_at(kSystem + kSystemLock) = kUnlock;
  register_at(kSystem + kSystemLcd) = kBlueInLowBits565;
  register_at(kSystem + kSystemLock) = 0;

  register_at(kLcd + kControl) = 0;
  // Horizontal fields hold the value minus one; of the vertical fields, only visible lines and pulse do.
  register_at(kLcd + kTiming0) =
      (columns_back - 1U) << 24 | (columns_front - 1U) << 16 | (columns_sync - 1U) << 8 | (columns / 16U - 1U) << 2;
  register_at(kLcd + kTiming1) = static_cast<std::uint32_t>(lines_back) << 24 |
                                 static_cast<std::uint32_t>(lines_front) << 16 | (lines_sync - 1U) << 10 | (lines - 1U);
  register_at(kLcd + kTiming2) = kBypassDivider | (columns - 1U) << 16;
  register_at(kLcd + kUpperBase) = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pixels));
  register_at(kLcd + kControl) = kEnable | kSixteenBits | kTft;
  register_at(kLcd + kControl) = kEnable | kSixteenBits | kTft | kPower;
}

}  // namespace zstrip::board
