// What nobody has seen run: each register and bit that the Picos' and the STM32F4's firmware names, against the makers'
// headers, put together here from block, offset and bit as they stand there; and the page that lists them.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "pico/chip.hpp"
#include "pico2/rp2350.hpp"
#include "stm32/f4_registers.hpp"
#include "stm32/spi.hpp"
#include "stm32/usart.hpp"
#include "stm32/watchdog.hpp"

namespace zstrip::boards {
namespace {

struct Fact {
  const char* name;
  std::uint32_t ours;
  std::uint32_t makers;
  const char* symbols;
};

#define FACT(space, name, makers, symbols) \
  Fact { #name, board::space::name, (makers), symbols }

constexpr std::uint32_t bit(unsigned number) { return 1U << number; }

// pico-sdk, src/rp2040/hardware_regs/include/hardware/regs: the header is the symbol's first word, the block's address
// is in addressmap.h.
namespace rp2040 {
constexpr std::uint32_t kClocks = 0x40008000, kResets = 0x4000C000, kPsm = 0x40010000, kXosc = 0x40024000;
constexpr std::uint32_t kPllSys = 0x40028000, kWatchdog = 0x40058000, kSio = 0xD0000000, kDma = 0x50000000;
constexpr std::uint32_t kTimer = 0x40054000;
}  // namespace rp2040

constexpr Fact kPico[] = {
    FACT(rp2040, kReset, rp2040::kResets + 0x0, "RESETS_RESET_OFFSET"),
    FACT(rp2040, kResetDone, rp2040::kResets + 0x8, "RESETS_RESET_DONE_OFFSET"),
    FACT(rp2040, kResetDma, bit(2), "RESETS_RESET_DMA_BITS"),
    FACT(rp2040, kResetIoBank0, bit(5), "RESETS_RESET_IO_BANK0_BITS"),
    FACT(rp2040, kResetPadsBank0, bit(8), "RESETS_RESET_PADS_BANK0_BITS"),
    FACT(rp2040, kResetPllSys, bit(12), "RESETS_RESET_PLL_SYS_BITS"),
    FACT(rp2040, kResetSpi0, bit(16), "RESETS_RESET_SPI0_BITS"),
    FACT(rp2040, kResetTimer, bit(21), "RESETS_RESET_TIMER_BITS"),
    FACT(rp2040, kResetUart0, bit(22), "RESETS_RESET_UART0_BITS"),
    FACT(rp2040, kCrystalControl, rp2040::kXosc + 0x0, "XOSC_CTRL_OFFSET"),
    FACT(rp2040, kCrystalStatus, rp2040::kXosc + 0x4, "XOSC_STATUS_OFFSET"),
    FACT(rp2040, kCrystalStartup, rp2040::kXosc + 0xC, "XOSC_STARTUP_OFFSET"),
    FACT(rp2040, kCrystalEnable, 0xFABU * bit(12) + 0xAA0U,
         "XOSC_CTRL_ENABLE_VALUE_ENABLE at 12, XOSC_CTRL_FREQ_RANGE_VALUE_1_15MHZ"),
    FACT(rp2040, kCrystalStable, bit(31), "XOSC_STATUS_STABLE_BITS"),
    FACT(rp2040, kReferenceControl, rp2040::kClocks + 0x30, "CLOCKS_CLK_REF_CTRL_OFFSET"),
    FACT(rp2040, kReferenceSelected, rp2040::kClocks + 0x38, "CLOCKS_CLK_REF_SELECTED_OFFSET"),
    FACT(rp2040, kReferenceFromCrystal, 2, "CLOCKS_CLK_REF_CTRL_SRC_VALUE_XOSC_CLKSRC"),
    FACT(rp2040, kSystemControl, rp2040::kClocks + 0x3C, "CLOCKS_CLK_SYS_CTRL_OFFSET"),
    FACT(rp2040, kSystemSelected, rp2040::kClocks + 0x44, "CLOCKS_CLK_SYS_SELECTED_OFFSET"),
    FACT(rp2040, kSystemFromAuxiliary, 1, "CLOCKS_CLK_SYS_CTRL_SRC_VALUE_CLKSRC_CLK_SYS_AUX"),
    FACT(rp2040, kPeripheralControl, rp2040::kClocks + 0x48, "CLOCKS_CLK_PERI_CTRL_OFFSET"),
    FACT(rp2040, kPeripheralEnable, bit(11), "CLOCKS_CLK_PERI_CTRL_ENABLE_BITS"),
    FACT(rp2040, kPllControl, rp2040::kPllSys + 0x0, "PLL_CS_OFFSET"),
    FACT(rp2040, kPllPower, rp2040::kPllSys + 0x4, "PLL_PWR_OFFSET"),
    FACT(rp2040, kPllFeedback, rp2040::kPllSys + 0x8, "PLL_FBDIV_INT_OFFSET"),
    FACT(rp2040, kPllPostDividers, rp2040::kPllSys + 0xC, "PLL_PRIM_OFFSET"),
    FACT(rp2040, kPllLocked, bit(31), "PLL_CS_LOCK_BITS"),
    FACT(rp2040, kPllPowerDown, bit(0), "PLL_PWR_PD_BITS"),
    FACT(rp2040, kPllPostDividersDown, bit(3), "PLL_PWR_POSTDIVPD_BITS"),
    FACT(rp2040, kPllVcoDown, bit(5), "PLL_PWR_VCOPD_BITS"),
    FACT(rp2040, kWatchdogResets, rp2040::kPsm + 0x8, "PSM_WDSEL_OFFSET"),
    FACT(rp2040, kAllButOscillators, 0x1FFFF - bit(0) - bit(1),
         "PSM_WDSEL_BITS without PSM_WDSEL_ROSC_BITS and PSM_WDSEL_XOSC_BITS"),
    FACT(rp2040, kWatchdogControl, rp2040::kWatchdog + 0x0, "WATCHDOG_CTRL_OFFSET"),
    FACT(rp2040, kWatchdogLoad, rp2040::kWatchdog + 0x4, "WATCHDOG_LOAD_OFFSET"),
    FACT(rp2040, kWatchdogTick, rp2040::kWatchdog + 0x2C, "WATCHDOG_TICK_OFFSET"),
    FACT(rp2040, kWatchdogEnable, bit(30), "WATCHDOG_CTRL_ENABLE_BITS"),
    FACT(rp2040, kTickEnable, bit(9), "WATCHDOG_TICK_ENABLE_BITS"),
    FACT(rp2040, kTimerUpper, rp2040::kTimer + 0x8, "TIMER_TIMEHR_OFFSET"),
    FACT(rp2040, kTimerLower, rp2040::kTimer + 0xC, "TIMER_TIMELR_OFFSET"),
    FACT(rp2040, kFunctionSpi, 1, "IO_BANK0_GPIO0_CTRL_FUNCSEL_VALUE_SPI0_RX"),
    FACT(rp2040, kFunctionUart, 2, "IO_BANK0_GPIO0_CTRL_FUNCSEL_VALUE_UART0_TX"),
    FACT(rp2040, kFunctionSio, 5, "IO_BANK0_GPIO0_CTRL_FUNCSEL_VALUE_SIO_0"),
    FACT(rp2040, kPinsSet, rp2040::kSio + 0x14, "SIO_GPIO_OUT_SET_OFFSET"),
    FACT(rp2040, kPinsClear, rp2040::kSio + 0x18, "SIO_GPIO_OUT_CLR_OFFSET"),
    FACT(rp2040, kPinsEnableOutput, rp2040::kSio + 0x24, "SIO_GPIO_OE_SET_OFFSET"),
    FACT(rp2040, kUart0, 0x40034000, "UART0_BASE"),
    FACT(rp2040, kSpi0, 0x4003C000, "SPI0_BASE"),
    FACT(rp2040, kDmaRead, rp2040::kDma + 0x0, "DMA_CH0_READ_ADDR_OFFSET"),
    FACT(rp2040, kDmaWrite, rp2040::kDma + 0x4, "DMA_CH0_WRITE_ADDR_OFFSET"),
    FACT(rp2040, kDmaCount, rp2040::kDma + 0x8, "DMA_CH0_TRANS_COUNT_OFFSET"),
    FACT(rp2040, kDmaControl, rp2040::kDma + 0xC, "DMA_CH0_CTRL_TRIG_OFFSET"),
    FACT(rp2040, kDmaEnable, bit(0), "DMA_CH0_CTRL_TRIG_EN_BITS"),
    FACT(rp2040, kDmaIncrementRead, bit(4), "DMA_CH0_CTRL_TRIG_INCR_READ_BITS"),
    FACT(rp2040, kDmaAtSpi0Pace, 16 * bit(15), "DREQ_SPI0_TX at DMA_CH0_CTRL_TRIG_TREQ_SEL_LSB"),
    FACT(rp2040, kDmaBusy, bit(24), "DMA_CH0_CTRL_TRIG_BUSY_BITS"),
    FACT(rp2040, kDmaFaults, bit(29) + bit(30),
         "DMA_CH0_CTRL_TRIG_WRITE_ERROR_BITS, DMA_CH0_CTRL_TRIG_READ_ERROR_BITS"),
    FACT(rp2040, kDmaAbort, rp2040::kDma + 0x444, "DMA_CHAN_ABORT_OFFSET"),
};

// pico-sdk, src/rp2350/hardware_regs/include/hardware/regs, likewise.
namespace rp2350 {
constexpr std::uint32_t kClocks = 0x40010000, kResets = 0x40020000, kPsm = 0x40018000, kXosc = 0x40048000;
constexpr std::uint32_t kPllSys = 0x40050000, kWatchdog = 0x400D8000, kTicks = 0x40108000, kSio = 0xD0000000;
constexpr std::uint32_t kDma = 0x50000000, kTimer0 = 0x400B0000;
}  // namespace rp2350

constexpr Fact kPico2[] = {
    FACT(rp2350, kReset, rp2350::kResets + 0x0, "RESETS_RESET_OFFSET"),
    FACT(rp2350, kResetDone, rp2350::kResets + 0x8, "RESETS_RESET_DONE_OFFSET"),
    FACT(rp2350, kResetDma, bit(2), "RESETS_RESET_DMA_BITS"),
    FACT(rp2350, kResetIoBank0, bit(6), "RESETS_RESET_IO_BANK0_BITS"),
    FACT(rp2350, kResetPadsBank0, bit(9), "RESETS_RESET_PADS_BANK0_BITS"),
    FACT(rp2350, kResetPllSys, bit(14), "RESETS_RESET_PLL_SYS_BITS"),
    FACT(rp2350, kResetSpi0, bit(18), "RESETS_RESET_SPI0_BITS"),
    FACT(rp2350, kResetTimer, bit(23), "RESETS_RESET_TIMER0_BITS"),
    FACT(rp2350, kResetUart0, bit(26), "RESETS_RESET_UART0_BITS"),
    FACT(rp2350, kCrystalControl, rp2350::kXosc + 0x0, "XOSC_CTRL_OFFSET"),
    FACT(rp2350, kCrystalStatus, rp2350::kXosc + 0x4, "XOSC_STATUS_OFFSET"),
    FACT(rp2350, kCrystalStartup, rp2350::kXosc + 0xC, "XOSC_STARTUP_OFFSET"),
    FACT(rp2350, kCrystalEnable, 0xFABU * bit(12) + 0xAA0U,
         "XOSC_CTRL_ENABLE_VALUE_ENABLE at 12, XOSC_CTRL_FREQ_RANGE_VALUE_1_15MHZ"),
    FACT(rp2350, kCrystalStable, bit(31), "XOSC_STATUS_STABLE_BITS"),
    FACT(rp2350, kReferenceControl, rp2350::kClocks + 0x30, "CLOCKS_CLK_REF_CTRL_OFFSET"),
    FACT(rp2350, kReferenceSelected, rp2350::kClocks + 0x38, "CLOCKS_CLK_REF_SELECTED_OFFSET"),
    FACT(rp2350, kReferenceFromCrystal, 2, "CLOCKS_CLK_REF_CTRL_SRC_VALUE_XOSC_CLKSRC"),
    FACT(rp2350, kSystemControl, rp2350::kClocks + 0x3C, "CLOCKS_CLK_SYS_CTRL_OFFSET"),
    FACT(rp2350, kSystemSelected, rp2350::kClocks + 0x44, "CLOCKS_CLK_SYS_SELECTED_OFFSET"),
    FACT(rp2350, kSystemFromAuxiliary, 1, "CLOCKS_CLK_SYS_CTRL_SRC_VALUE_CLKSRC_CLK_SYS_AUX"),
    FACT(rp2350, kPeripheralControl, rp2350::kClocks + 0x48, "CLOCKS_CLK_PERI_CTRL_OFFSET"),
    FACT(rp2350, kPeripheralEnable, bit(11), "CLOCKS_CLK_PERI_CTRL_ENABLE_BITS"),
    FACT(rp2350, kPllControl, rp2350::kPllSys + 0x0, "PLL_CS_OFFSET"),
    FACT(rp2350, kPllPower, rp2350::kPllSys + 0x4, "PLL_PWR_OFFSET"),
    FACT(rp2350, kPllFeedback, rp2350::kPllSys + 0x8, "PLL_FBDIV_INT_OFFSET"),
    FACT(rp2350, kPllPostDividers, rp2350::kPllSys + 0xC, "PLL_PRIM_OFFSET"),
    FACT(rp2350, kPllLocked, bit(31), "PLL_CS_LOCK_BITS"),
    FACT(rp2350, kPllPowerDown, bit(0), "PLL_PWR_PD_BITS"),
    FACT(rp2350, kPllPostDividersDown, bit(3), "PLL_PWR_POSTDIVPD_BITS"),
    FACT(rp2350, kPllVcoDown, bit(5), "PLL_PWR_VCOPD_BITS"),
    FACT(rp2350, kWatchdogResets, rp2350::kPsm + 0x8, "PSM_WDSEL_OFFSET"),
    FACT(rp2350, kAllButOscillators, 0x1FFFFFF - bit(2) - bit(3),
         "PSM_WDSEL_BITS without PSM_WDSEL_ROSC_BITS and PSM_WDSEL_XOSC_BITS"),
    FACT(rp2350, kWatchdogControl, rp2350::kWatchdog + 0x0, "WATCHDOG_CTRL_OFFSET"),
    FACT(rp2350, kWatchdogLoad, rp2350::kWatchdog + 0x4, "WATCHDOG_LOAD_OFFSET"),
    FACT(rp2350, kWatchdogEnable, bit(30), "WATCHDOG_CTRL_ENABLE_BITS"),
    FACT(rp2350, kWatchdogTick, rp2350::kTicks + 0x30, "TICKS_WATCHDOG_CTRL_OFFSET"),
    FACT(rp2350, kWatchdogTickCycles, rp2350::kTicks + 0x34, "TICKS_WATCHDOG_CYCLES_OFFSET"),
    FACT(rp2350, kTickEnable, bit(0), "TICKS_WATCHDOG_CTRL_ENABLE_BITS"),
    FACT(rp2350, kTimerUpper, rp2350::kTimer0 + 0x8, "TIMER_TIMEHR_OFFSET"),
    FACT(rp2350, kTimerLower, rp2350::kTimer0 + 0xC, "TIMER_TIMELR_OFFSET"),
    FACT(rp2350, kTimerTick, rp2350::kTicks + 0x18, "TICKS_TIMER0_CTRL_OFFSET"),
    FACT(rp2350, kTimerTickCycles, rp2350::kTicks + 0x1C, "TICKS_TIMER0_CYCLES_OFFSET"),
    FACT(rp2350, kFunctionSpi, 1, "GPIO_FUNC_SPI"),
    FACT(rp2350, kFunctionUart, 2, "GPIO_FUNC_UART"),
    FACT(rp2350, kFunctionSio, 5, "GPIO_FUNC_SIO"),
    FACT(rp2350, kPadSchmitt, bit(1), "PADS_BANK0_GPIO0_SCHMITT_BITS"),
    FACT(rp2350, kPadPullDown, bit(2), "PADS_BANK0_GPIO0_PDE_BITS"),
    FACT(rp2350, kPadPullUp, bit(3), "PADS_BANK0_GPIO0_PUE_BITS"),
    FACT(rp2350, kPad4Milliamperes, 1 * bit(4), "PADS_BANK0_GPIO0_DRIVE_VALUE_4MA at PADS_BANK0_GPIO0_DRIVE_LSB"),
    FACT(rp2350, kPadInput, bit(6), "PADS_BANK0_GPIO0_IE_BITS"),
    FACT(rp2350, kPinsSet, rp2350::kSio + 0x18, "SIO_GPIO_OUT_SET_OFFSET"),
    FACT(rp2350, kPinsClear, rp2350::kSio + 0x20, "SIO_GPIO_OUT_CLR_OFFSET"),
    FACT(rp2350, kPinsEnableOutput, rp2350::kSio + 0x38, "SIO_GPIO_OE_SET_OFFSET"),
    FACT(rp2350, kUart0, 0x40070000, "UART0_BASE"),
    FACT(rp2350, kSpi0, 0x40080000, "SPI0_BASE"),
    FACT(rp2350, kDmaRead, rp2350::kDma + 0x0, "DMA_CH0_READ_ADDR_OFFSET"),
    FACT(rp2350, kDmaWrite, rp2350::kDma + 0x4, "DMA_CH0_WRITE_ADDR_OFFSET"),
    FACT(rp2350, kDmaCount, rp2350::kDma + 0x8, "DMA_CH0_TRANS_COUNT_OFFSET"),
    FACT(rp2350, kDmaControl, rp2350::kDma + 0xC, "DMA_CH0_CTRL_TRIG_OFFSET"),
    FACT(rp2350, kDmaControlOnly, rp2350::kDma + 0x10, "DMA_CH0_AL1_CTRL_OFFSET"),
    FACT(rp2350, kDmaEnable, bit(0), "DMA_CH0_CTRL_TRIG_EN_BITS"),
    FACT(rp2350, kDmaIncrementRead, bit(4), "DMA_CH0_CTRL_TRIG_INCR_READ_BITS"),
    FACT(rp2350, kDmaAtSpi0Pace, 24 * bit(17), "DREQ_SPI0_TX at DMA_CH0_CTRL_TRIG_TREQ_SEL_LSB"),
    FACT(rp2350, kDmaBusy, bit(26), "DMA_CH0_CTRL_TRIG_BUSY_BITS"),
    FACT(rp2350, kDmaFaults, bit(29) + bit(30),
         "DMA_CH0_CTRL_TRIG_WRITE_ERROR_BITS, DMA_CH0_CTRL_TRIG_READ_ERROR_BITS"),
    FACT(rp2350, kDmaAbort, rp2350::kDma + 0x464, "DMA_CHAN_ABORT_OFFSET"),
};

// Both chips' SPI is Arm's PL022.
constexpr Fact kPicos[] = {
    FACT(chip, kSpiControl0, 0x0, "SPI_SSPCR0_OFFSET"),
    FACT(chip, kSpiControl1, 0x4, "SPI_SSPCR1_OFFSET"),
    FACT(chip, kSpiData, 0x8, "SPI_SSPDR_OFFSET"),
    FACT(chip, kSpiStatus, 0xC, "SPI_SSPSR_OFFSET"),
    FACT(chip, kSpiPrescale, 0x10, "SPI_SSPCPSR_OFFSET"),
    FACT(chip, kSpiDma, 0x24, "SPI_SSPDMACR_OFFSET"),
    FACT(chip, kSpiTransmitByDma, bit(1), "SPI_SSPDMACR_TXDMAE_BITS"),
    FACT(chip, kSpiTransmitNotFull, bit(1), "SPI_SSPSR_TNF_BITS"),
    FACT(chip, kSpiReceiveNotEmpty, bit(2), "SPI_SSPSR_RNE_BITS"),
    FACT(chip, kSpiBusy, bit(4), "SPI_SSPSR_BSY_BITS"),
};

// cmsis_device_f4, Include/stm32f407xx.h: blocks, structures and bits.
namespace stm32f4 {
constexpr std::uint32_t kApb1 = 0x40000000, kAhb1 = kApb1 + 0x20000;
constexpr std::uint32_t kRcc = kAhb1 + 0x3800, kDma2 = kAhb1 + 0x6400, kStream3 = kDma2 + 0x58;
}  // namespace stm32f4

constexpr Fact kStm32f4[] = {
    FACT(stm32, kClockControl, stm32f4::kRcc + 0x00, "RCC->CR"),
    FACT(stm32, kHseOn, bit(16), "RCC_CR_HSEON"),
    FACT(stm32, kHseReady, bit(17), "RCC_CR_HSERDY"),
    FACT(stm32, kPllOn, bit(24), "RCC_CR_PLLON"),
    FACT(stm32, kPllReady, bit(25), "RCC_CR_PLLRDY"),
    FACT(stm32, kPllConfig, stm32f4::kRcc + 0x04, "RCC->PLLCFGR"),
    FACT(stm32, kPllNShift, 6, "RCC_PLLCFGR_PLLN_Pos"),
    FACT(stm32, kPllPShift, 16, "RCC_PLLCFGR_PLLP_Pos"),
    FACT(stm32, kPllFromHse, bit(22), "RCC_PLLCFGR_PLLSRC_HSE"),
    FACT(stm32, kPllQShift, 24, "RCC_PLLCFGR_PLLQ_Pos"),
    FACT(stm32, kPllReserved, ~(0x3FU + 0x7FC0U + 0x30000U + bit(22) + 0xF000000U),
         "all but RCC_PLLCFGR_PLLM, PLLN, PLLP, PLLSRC, PLLQ"),
    FACT(stm32, kClockConfig, stm32f4::kRcc + 0x08, "RCC->CFGR"),
    FACT(stm32, kApb1By4, 0x1400, "RCC_CFGR_PPRE1_DIV4"),
    FACT(stm32, kApb2By2, 0x8000, "RCC_CFGR_PPRE2_DIV2"),
    FACT(stm32, kUsePll, 2, "RCC_CFGR_SW_PLL"),
    FACT(stm32, kUsesPll, 8, "RCC_CFGR_SWS_PLL"),
    FACT(stm32, kUsedMask, 0xC, "RCC_CFGR_SWS_Msk"),
    FACT(stm32, kAhb1Enable, stm32f4::kRcc + 0x30, "RCC->AHB1ENR"),
    FACT(stm32, kAhb1Dma2, bit(22), "RCC_AHB1ENR_DMA2EN"),
    FACT(stm32, kApb1Enable, stm32f4::kRcc + 0x40, "RCC->APB1ENR"),
    FACT(stm32, kApb1Spi2, bit(14), "RCC_APB1ENR_SPI2EN"),
    FACT(stm32, kApb1Usart2, bit(17), "RCC_APB1ENR_USART2EN"),
    FACT(stm32, kApb1Power, bit(28), "RCC_APB1ENR_PWREN"),
    FACT(stm32, kApb2Enable, stm32f4::kRcc + 0x44, "RCC->APB2ENR"),
    FACT(stm32, kApb2Usart6, bit(5), "RCC_APB2ENR_USART6EN"),
    FACT(stm32, kApb2Spi1, bit(12), "RCC_APB2ENR_SPI1EN"),
    FACT(stm32, kPowerControl, stm32f4::kApb1 + 0x7000, "PWR->CR"),
    FACT(stm32, kVoltageScale1, bit(14), "PWR_CR_VOS"),
    FACT(stm32, kFlashAccess, stm32f4::kAhb1 + 0x3C00, "FLASH->ACR"),
    FACT(stm32, kWaitStates5, 5, "FLASH_ACR_LATENCY_5WS"),
    FACT(stm32, kWaitStatesMask, 7, "FLASH_ACR_LATENCY_Msk"),
    FACT(stm32, kPrefetch, bit(8), "FLASH_ACR_PRFTEN"),
    FACT(stm32, kInstructionCache, bit(9), "FLASH_ACR_ICEN"),
    FACT(stm32, kDataCache, bit(10), "FLASH_ACR_DCEN"),
    FACT(stm32, kGpioMode, 0x00, "GPIO_TypeDef.MODER"),
    FACT(stm32, kGpioSpeed, 0x08, "GPIO_TypeDef.OSPEEDR"),
    FACT(stm32, kGpioSetReset, 0x18, "GPIO_TypeDef.BSRR"),
    FACT(stm32, kGpioAlternateLow, 0x20, "GPIO_TypeDef.AFR[0]"),
    FACT(stm32, kGpioAlternateHigh, 0x24, "GPIO_TypeDef.AFR[1]"),
    FACT(stm32, kGpioOutput, 1, "GPIO_MODER_MODER0_0"),
    FACT(stm32, kGpioAlternate, 2, "GPIO_MODER_MODER0_1"),
    FACT(stm32, kGpioHighSpeed, 2, "GPIO_OSPEEDR_OSPEED0_1"),
    FACT(stm32, kDma2, stm32f4::kDma2, "DMA2_BASE"),
    FACT(stm32, kDmaStatusLow, stm32f4::kDma2 + 0x00, "DMA2->LISR"),
    FACT(stm32, kDmaClearLow, stm32f4::kDma2 + 0x08, "DMA2->LIFCR"),
    FACT(stm32, kDmaAllFlags3, bit(22) + bit(24) + bit(25) + bit(26) + bit(27),
         "DMA_LISR_FEIF3, DMEIF3, TEIF3, HTIF3, TCIF3"),
    FACT(stm32, kDmaFaults3, bit(24) + bit(25), "DMA_LISR_DMEIF3, DMA_LISR_TEIF3"),
    FACT(stm32, kDmaComplete3, bit(27), "DMA_LISR_TCIF3"),
    FACT(stm32, kDmaStream3, stm32f4::kStream3, "DMA2_Stream3_BASE"),
    FACT(stm32, kDmaConfig3, stm32f4::kStream3 + 0x00, "DMA2_Stream3->CR"),
    FACT(stm32, kDmaCount3, stm32f4::kStream3 + 0x04, "DMA2_Stream3->NDTR"),
    FACT(stm32, kDmaPeripheral3, stm32f4::kStream3 + 0x08, "DMA2_Stream3->PAR"),
    FACT(stm32, kDmaMemory3, stm32f4::kStream3 + 0x0C, "DMA2_Stream3->M0AR"),
    FACT(stm32, kDmaEnable, bit(0), "DMA_SxCR_EN"),
    FACT(stm32, kDmaFromMemory, bit(6), "DMA_SxCR_DIR_0"),
    FACT(stm32, kDmaIncrementMemory, bit(10), "DMA_SxCR_MINC"),
    FACT(stm32, kDmaChannel3, 0x02000000 + 0x04000000, "DMA_SxCR_CHSEL_0, DMA_SxCR_CHSEL_1"),
};

constexpr Fact kStm32Shared[] = {
    FACT(stm32, kSpiControl1, 0x00, "SPI_TypeDef.CR1"),
    FACT(stm32, kSpiControl2, 0x04, "SPI_TypeDef.CR2"),
    FACT(stm32, kSpiStatus, 0x08, "SPI_TypeDef.SR"),
    FACT(stm32, kSpiData, 0x0C, "SPI_TypeDef.DR"),
    FACT(stm32, kSpiMaster, bit(2), "SPI_CR1_MSTR"),
    FACT(stm32, kSpiDividerShift, 3, "SPI_CR1_BR_Pos"),
    FACT(stm32, kSpiEnable, bit(6), "SPI_CR1_SPE"),
    FACT(stm32, kSpiSelectInternal, bit(8) + bit(9), "SPI_CR1_SSI, SPI_CR1_SSM"),
    FACT(stm32, kSpiTransmitByDma, bit(1), "SPI_CR2_TXDMAEN"),
    FACT(stm32, kSpiTransmitEmpty, bit(1), "SPI_SR_TXE"),
    FACT(stm32, kSpiBusy, bit(7), "SPI_SR_BSY"),
    FACT(stm32, kWatchdogKey, stm32f4::kApb1 + 0x3000, "IWDG->KR"),
};

std::vector<Fact> all_facts() {
  std::vector<Fact> facts;
  for (const std::span<const Fact> table :
       {std::span<const Fact>(kPico), {kPico2}, {kPicos}, {kStm32f4}, {kStm32Shared}})
    facts.insert(facts.end(), table.begin(), table.end());
  return facts;
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(std::filesystem::path(ZSTRIP_ROOT) / file);
  EXPECT_TRUE(stream) << file;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

TEST(BoardReview, ConstantsAreTheMakers) {
  for (const Fact& fact : all_facts()) EXPECT_EQ(fact.ours, fact.makers) << fact.name << ": " << fact.symbols;
  EXPECT_EQ(board::rp2040::pin_control(19), 0x40014000 + 0x9C) << "IO_BANK0_GPIO19_CTRL_OFFSET";
  EXPECT_EQ(board::rp2350::pin_control(19), 0x40028000 + 0x9C) << "IO_BANK0_GPIO19_CTRL_OFFSET";
  EXPECT_EQ(board::rp2350::pad(19), 0x40038000 + 0x50) << "PADS_BANK0_GPIO19_OFFSET";
  EXPECT_EQ(board::stm32::gpio_f4('A'), stm32f4::kAhb1) << "GPIOA_BASE";
  EXPECT_EQ(board::stm32::gpio_f4('E'), stm32f4::kAhb1 + 0x1000) << "GPIOE_BASE";
  using Usart2 = board::stm32::Usart<stm32f4::kApb1 + 0x4400>;
  EXPECT_EQ(Usart2::kStatus, 0x40004400U) << "USART2->SR";
  EXPECT_EQ(Usart2::kData, 0x40004404U) << "USART2->DR";
  EXPECT_EQ(Usart2::kBaudRate, 0x40004408U) << "USART2->BRR";
  EXPECT_EQ(Usart2::kControl1, 0x4000440CU) << "USART2->CR1";
}

/// Names that begin with k and a capital and are given a value.
std::set<std::string> constants_of(const std::string& header) {
  std::set<std::string> names;
  for (std::size_t end = header.find(" = "); end != std::string::npos; end = header.find(" = ", end + 1)) {
    std::size_t begin = end;
    while (begin > 0 && (std::isalnum(static_cast<unsigned char>(header[begin - 1])) || header[begin - 1] == '_'))
      --begin;
    const std::string name = header.substr(begin, end - begin);
    if (name.size() > 1 && name[0] == 'k' && name[1] >= 'A' && name[1] <= 'Z') names.insert(name);
  }
  return names;
}

// None is forgotten: a new one is looked up, and written here and in the table.
TEST(BoardReview, EveryConstantOfTheHeadersIsThere) {
  std::map<std::string, std::set<std::string>> known;
  for (const Fact& fact : kPico) known["firmware/boards/pico/rp2040.hpp"].insert(fact.name);
  for (const Fact& fact : kPico2) known["firmware/boards/pico2/rp2350.hpp"].insert(fact.name);
  for (const Fact& fact : kPicos) known["firmware/boards/pico/chip.hpp"].insert(fact.name);
  for (const Fact& fact : kStm32f4) known["firmware/boards/stm32/f4_registers.hpp"].insert(fact.name);
  for (const auto& [file, names] : known) {
    EXPECT_EQ(constants_of(contents(file)), names) << file;
  }
}

TEST(BoardReview, TableListsThem) {
  const std::string table = contents("docs/hardware-review.csv");
  for (const Fact& fact : all_facts()) {
    char row[400];
    std::snprintf(row, sizeof row, "\n%s,0x%X,\"%s\",", fact.name, static_cast<unsigned>(fact.ours), fact.symbols);
    EXPECT_NE(table.find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace zstrip::boards
