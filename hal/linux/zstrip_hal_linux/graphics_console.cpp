// Keeps the machine's text console off the screen while pictures are shown.
#include "zstrip_hal_linux/graphics_console.hpp"

#include <fcntl.h>
#include <linux/kd.h>
#include <sys/ioctl.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>

namespace zstrip::hal {
namespace {

constexpr const char* kShown = "/dev/tty0";
constexpr std::array kFatalSignals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGQUIT, SIGTRAP, SIGSYS};

// For the signal handler, which may read no other data. -1: no console is in graphics mode.
volatile std::sig_atomic_t console_file = -1;
volatile std::sig_atomic_t former_console_mode = KD_TEXT;

void set_mode(int file, int mode) { static_cast<void>(ioctl(file, KDSETMODE, static_cast<std::intptr_t>(mode))); }

/// SA_RESETHAND has already restored the signal's default action, so raising the signal again ends the program.
void restore_and_end(int signal) {
  if (console_file >= 0) set_mode(console_file, former_console_mode);
  static_cast<void>(raise(signal));
}

void on_fatal_signals(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : kFatalSignals) sigaction(signal, &action, nullptr);
}

}  // namespace

ConsoleMode console_mode() {
  const FileDescriptor file(open(kShown, O_RDONLY | O_CLOEXEC | O_NOCTTY));
  int mode = KD_TEXT;
  if (!file || ioctl(file.get(), KDGETMODE, &mode) != 0) return ConsoleMode::none;
  return mode == KD_TEXT ? ConsoleMode::text : ConsoleMode::graphics;
}

Outcome<GraphicsConsole> GraphicsConsole::enter() {
  const std::string shown = kShown;
  FileDescriptor file;
  int mode = KD_TEXT;
  for (const std::string& path : {std::string("/dev/tty"), shown}) {
    file = FileDescriptor(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOCTTY));
    if (file && ioctl(file.get(), KDGETMODE, &mode) == 0) break;
    // /dev/tty is a console only for a program that was started on one.
    if (path != shown) continue;
    if (file || errno == ENOENT || errno == ENXIO || errno == ENODEV) return GraphicsConsole();
    return device_fault(DeviceKind::console, path, "be opened", errno);
  }
  if (ioctl(file.get(), KDSETMODE, std::intptr_t{KD_GRAPHICS}) != 0)
    return device_fault(DeviceKind::console, "the console", "be set to graphics mode", errno);
  former_console_mode = mode;
  console_file = file.get();
  on_fatal_signals(restore_and_end);
  return GraphicsConsole(std::move(file), mode);
}

GraphicsConsole::~GraphicsConsole() {
  if (!file_) return;
  set_mode(file_.get(), former_mode_);
  console_file = -1;
  on_fatal_signals(SIG_DFL);
}

}  // namespace zstrip::hal
