// The main program of the scenes on bochs-display.
#pragma once

#include <cstddef>
#include <span>

#include "portable/panic.hpp"
#include "portable/scene_loop.hpp"
#include "portable/scene_player.hpp"
#include "portable/turntable_motion.hpp"
#include "riscv_virt/bochs_display.hpp"

namespace zstrip::board {

/// Shows the frames of `Player` for ever; main returns the result if there is no display.
template <class Player, View view>
int run_on_bochs_display() {
  constexpr std::uint32_t kRowBytes = bytes_per_row(view.width, view.format);
  static_assert(kRowBytes * view.height <= kBochsBytes);
  if (!start_bochs_display(view.width, view.height, kRowBytes / view.width * 8)) {
    print(Failure{"start of the display", "there is no bochs-display"});
    return 1;
  }
  hal::Framebuffer display({reinterpret_cast<std::byte*>(kBochsPixels), kBochsBytes},
                           {view.width, view.height, static_cast<hal::DisplayFormat>(view.format)});
  start_pacing();
  panic(display, show_scene<Player>(display));
  for (;;) asm volatile("wfi");  // the emulator would end with main, and close the screen with the message
}

/// Shows `scene` on the turntable for ever, drawn with a preset; main returns the result.
template <const scenes::BuiltIn& scene, View view, const Quality& preset = quality::balanced>
int show_on_bochs_display() {
  constexpr Budget kBudget{.bytes = 256 * 1024, .strip_buffers = 1};
  return run_on_bochs_display<ScenePlayer<TurntableMotion<scene, view, kBudget, 64, preset>>, view>();
}

}  // namespace zstrip::board
