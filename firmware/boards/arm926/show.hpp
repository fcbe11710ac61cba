// The main program of the scenes on the board's LCD.
#pragma once

#include <array>
#include <cstddef>

#include "arm926/pl110.hpp"
#include "portable/panic.hpp"
#include "portable/scene_loop.hpp"
#include "portable/scene_player.hpp"
#include "portable/turntable_motion.hpp"

namespace zstrip::board {

/// `scene` on the turntable for ever; the result is main's.
template <const scenes::BuiltIn& scene, LcdMode mode>
int show_on_lcd() {
  constexpr std::uint16_t kWidth = mode.horizontal.visible, kHeight = mode.vertical.visible;
  constexpr View kView{kWidth, kHeight, PixelFormat::rgb565};
  constexpr Budget kBudget{.bytes = 256 * 1024, .strip_buffers = 1};
  alignas(8) static std::array<std::byte, kHeight * bytes_per_row(kWidth, kView.format)> picture;
  start_lcd(mode, picture.data());
  hal::Framebuffer lcd(picture, {kWidth, kHeight, hal::PixelFormat::rgb565});
  start_pacing();
  panic(lcd, show_scene<ScenePlayer<TurntableMotion<scene, kView, kBudget>>>(lcd));
  return 1;
}

}  // namespace zstrip::board
