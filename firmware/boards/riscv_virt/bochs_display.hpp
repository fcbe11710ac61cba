// QEMU's bochs-display, a framebuffer behind PCI Express.
#pragma once

#include <cstdint>

#include "zstrip_hal/framebuffer.hpp"

namespace zstrip::board {

/// Where the display's pixels are, and the most bytes of them that are used.
inline constexpr std::uintptr_t kBochsPixels = 0x40000000;
inline constexpr std::uint32_t kBochsBytes = 4 << 20;

/// Finds the display among the devices of the first bus, gives it its addresses and sets the mode; rows have no gaps.
/// False if there is none (-device bochs-display). `bits` a pixel: 16 (RGB565) or 32 (XRGB8888).
bool start_bochs_display(std::uint16_t width, std::uint16_t height, std::uint16_t bits);

}  // namespace zstrip::board
