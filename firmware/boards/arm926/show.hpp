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

template <LcdMode mode>
inline constexpr View kLcdView{mode.horizontal.visible, mode.vertical.visible, PixelFormat::rgb565};

/// Shows the frames of `Player` for ever; main returns the result.
template <class Player, LcdMode mode>
int run_on_lcd() {
  constexpr View kView = kLcdView<mode>;
  alignas(8) static std::array<std::byte, kView.height * bytes_per_row(kView.width, kView.format)> picture;
  start_lcd(mode, picture.data());
  hal::Framebuffer lcd(picture, {kView.width, kView.height, hal::DisplayFormat::rgb565});
  start_pacing();
  panic(lcd, show_scene<Player>(lcd));
  return 1;
}

/// Shows `scene` on the turntable for ever, drawn with a preset; main returns the result.
template <const scenes::BuiltIn& scene, LcdMode mode, const Quality& preset = quality::balanced>
int show_on_lcd() {
  constexpr Budget kBudget{.bytes = 256 * 1024, .strip_buffers = 1};
  return run_on_lcd<ScenePlayer<TurntableMotion<scene, kLcdView<mode>, kBudget, 64, preset>>, mode>();
}

}  // namespace zstrip::board
