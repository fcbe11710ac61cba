// Keeps the machine's text console off the screen while pictures are shown.
#pragma once

#include <cstdint>

#include "zstrip_hal_linux/device.hpp"

namespace zstrip::hal {

/// Mode of the console that is on the screen.
enum class ConsoleMode : std::uint8_t {
  text,      ///< it draws
  graphics,  ///< it draws nothing
  none,      ///< the machine has no console
};

/// Returns the mode; ConsoleMode::none also without the permission to read it.
ConsoleMode console_mode();

/// The console is in graphics mode (KD_GRAPHICS: it draws nothing, no cursor blinks) as long as this object lives;
/// then it gets its former mode back, also if the program ends by SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGQUIT,
/// SIGTRAP or SIGSYS. The program itself must catch the signals that ask it to end. After SIGKILL the console stays
/// dark until `kbd_mode` or another program sets its mode. Only one object may exist at a time.
class GraphicsConsole {
 public:
  /// Uses the terminal that the program runs on, if that is a console, else the one on the screen (/dev/tty0). On a
  /// machine without text consoles it does nothing and succeeds. Errors: no permission.
  static Outcome<GraphicsConsole> enter();

  /// An empty object: leaves the console alone.
  GraphicsConsole() = default;
  /// The moved-from object leaves the console alone.
  GraphicsConsole(GraphicsConsole&&) = default;
  GraphicsConsole& operator=(GraphicsConsole&&) = delete;
  ~GraphicsConsole();

 private:
  GraphicsConsole(FileDescriptor file, int former_mode) : file_(std::move(file)), former_mode_(former_mode) {}

  FileDescriptor file_;
  int former_mode_ = 0;
};

}  // namespace zstrip::hal
