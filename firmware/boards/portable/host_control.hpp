// A host on the console can control the frames: 'p' pauses, 'n' shows the next frame, 'r' continues. While paused, each
// shown frame is announced as "frame N", or "frame N, M pixels" if only M were drawn.
#pragma once

#include <cstdint>

#include "cortex_m/console.hpp"
#include "portable/console_input.hpp"
#include "portable/pacing.hpp"

namespace zstrip::board {

class HostControl {
 public:
  bool paused() const { return paused_; }
  /// Call it after a frame was shown. Returns when the next one may be drawn: at once, unless the host has paused.
  void frame_shown(std::uint32_t frame, std::uint32_t pixels = 0) {
    bool next = take_command();
    if (!paused_) return;
    print("frame ");
    print_decimal(frame);
    if (pixels != 0) {
      print(", ");
      print_decimal(pixels);
      print(" pixels");
    }
    print("\n");
    while (paused_ && !next) {
      wait_for_tick();
      feed_watchdog();
      next = take_command();
    }
  }

 private:
  /// True if the host requests the next frame.
  bool take_command() {
    char command = 0;
    if (!take_character(command)) return false;
    if (command == 'p') paused_ = true;
    if (command == 'r') paused_ = false;
    return command == 'n';
  }

  bool paused_ = false;
};

}  // namespace zstrip::board
