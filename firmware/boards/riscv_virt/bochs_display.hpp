// QEMU's bochs-display, a framebuffer behind PCI Express.
#pragma once

#include <cstdint>

#include "zstrip_hal/framebuffer.hpp"

namespace zstrip::board {

/// The address of the display's pixels, and the largest number of their bytes that is used.
inline constexpr std::uintptr_t kBochsPixels = 0x40000000;
inline constexpr std::uint32_t kBochsBytes = 4 << 20;

/// Finds the display among the devices of the first bus, assigns its addresses and sets the mode; rows have no gaps.
/// Returns false if there is none (-device bochs-display). `bits` a pixel: 16 (RGB565) or 32 (XRGB8888).
bool start_bochs_display(std::uint16_t width, std::uint16_t height, std::uint16_t bits);

}  // namespace zstrip::board
