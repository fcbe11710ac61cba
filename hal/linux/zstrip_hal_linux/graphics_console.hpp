// The machine's text console, kept off the screen while pictures are shown.
#pragma once

#include <cstdint>

#include "zstrip_hal_linux/device.hpp"

namespace zstrip::hal {

/// Of the console that is shown.
enum class ConsoleMode : std::uint8_t {
  text,      ///< it draws
  graphics,  ///< it draws nothing
  none,      ///< there is none
};

/// ConsoleMode::none also without the permission to read it.
ConsoleMode console_mode();

/// The console is in graphics mode (KD_GRAPHICS: it draws nothing, no cursor blinks) as long as this object lives, and
/// then in the mode that it had before; also if the program ends by SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT,
/// SIGQUIT, SIGTRAP or SIGSYS. The signals that ask a program to end are the program's to catch; SIGKILL leaves the
/// console dark until `kbd_mode` or another program sets it right. One object at a time.
class GraphicsConsole {
 public:
  /// The terminal that the program runs on, if that is a console, else the one that is shown (/dev/tty0). A machine
  /// without text consoles needs nothing: success. Errors: no permission.
  static Outcome<GraphicsConsole> enter();

  /// Nothing: leaves the console alone.
  GraphicsConsole() = default;
  /// The other one leaves the console alone.
  GraphicsConsole(GraphicsConsole&&) = default;
  GraphicsConsole& operator=(GraphicsConsole&&) = delete;
  ~GraphicsConsole();

 private:
  GraphicsConsole(FileDescriptor file, int former_mode) : file_(std::move(file)), former_mode_(former_mode) {}

  FileDescriptor file_;
  int former_mode_ = 0;
};

}  // namespace zstrip::hal
