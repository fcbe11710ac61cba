// The Versatile/PB's LCD controller, PL110.
#pragma once

#include <cstdint>

#include "zstrip_hal/framebuffer.hpp"

namespace zstrip::board {

/// The timing of the picture's lines or columns, in pixel clocks or lines.
struct LcdTiming {
  std::uint16_t visible;
  std::uint8_t sync, front_porch, back_porch;
};

struct LcdMode {
  LcdTiming horizontal, vertical;
};

/// The board's 3.8 inch panel and a VGA monitor. The pixel clock is that of the board's oscillator 4 after a reset.
inline constexpr LcdMode kQvga{{320, 6, 6, 6}, {240, 6, 5, 5}};
inline constexpr LcdMode kVga{{640, 96, 24, 40}, {480, 2, 11, 32}};

/// Begins to show `pixels`, RGB565 without gaps. They must be aligned to 8 bytes and must not move. The width must be a
/// multiple of 16.
void start_lcd(const LcdMode& mode, const std::byte* pixels);

}  // namespace zstrip::board
