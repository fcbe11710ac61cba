// Selects the board's chip, RP2040 or RP2350, by the target processor, and defines what both share. An RP2350 has Arm
// and RISC-V processors. Source: their data sheets; chapter numbers are those of the RP2040's.
#pragma once

#if defined(__ARM_ARCH_8M_MAIN__) || defined(__riscv)
#include "pico2/rp2350.hpp"
#else
#include "pico/rp2040.hpp"
#endif

namespace zstrip::board::chip {

#if defined(__ARM_ARCH_8M_MAIN__) || defined(__riscv)
using namespace rp2350;
#else
using namespace rp2040;
#endif

// Every register of the slow buses has aliases that set or clear the bits written (2.1.2).
inline void set_bits(std::uint32_t address, std::uint32_t bits) { register_at(address + 0x2000) = bits; }
inline void clear_bits(std::uint32_t address, std::uint32_t bits) { register_at(address + 0x3000) = bits; }

/// Completes all writes to memory before the next access.
inline void finish_writes() {
#if defined(__riscv)
  asm volatile("fence" ::: "memory");
#else
  asm volatile("dsb" ::: "memory");
#endif
}

// 4.4, SPI (PL022), offsets from its first register
inline constexpr std::uint32_t kSpiControl0 = 0x000, kSpiControl1 = 0x004, kSpiData = 0x008, kSpiStatus = 0x00C;
inline constexpr std::uint32_t kSpiPrescale = 0x010, kSpiDma = 0x024, kSpiTransmitByDma = 1U << 1;
inline constexpr std::uint32_t kSpiTransmitNotFull = 1U << 1, kSpiReceiveNotEmpty = 1U << 2, kSpiBusy = 1U << 4;

}  // namespace zstrip::board::chip
