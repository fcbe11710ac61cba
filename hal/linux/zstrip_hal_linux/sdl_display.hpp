// A window of the desktop, Wayland or X11, as a display. In a library of its own, because zstrip::hal_linux_sdl needs
// SDL 2.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal_linux/outcome.hpp"
#include "zstrip_hal_linux/screen_size.hpp"

namespace zstrip::hal {

/// Takes RGB565. Each pixel becomes a square of `scale` pixels in the window, in the colour that an XRGB8888 screen
/// shows. A frame appears whole; end_frame() returns about once for each refresh of the screen. A frame may write only
/// the areas that change. Call all functions on the thread that opened the window. Error::bus: the desktop refuses a
/// picture.
class SdlDisplay {
 public:
  static constexpr std::uint16_t kMaxScale = 8;  ///< pixels of the window for one of the picture, each way

  /// The window is black at first. `size` * `scale` is at most kMaxScreen, each side. Faults: no desktop, or the
  /// desktop has no memory for this size.
  static Outcome<SdlDisplay> open(const std::string& title, const ScreenSize& size, std::uint16_t scale);

  /// @{
  /// See the concept Display.
  std::uint16_t width() const { return size_.width; }
  std::uint16_t height() const { return size_.height; }
  DisplayFormat format() const { return DisplayFormat::rgb565; }

  Error begin_frame() { return Error::none; }
  Error write(const Area& area, std::span<const std::byte> pixels);
  Error wait() { return Error::none; }
  Error end_frame();
  /// @}
  /// True if the user has closed the window. Call it some times a second: it answers the desktop, which otherwise
  /// reports that the program hangs, and it shows the picture again after another window covered it.
  bool is_closed();

 private:
  struct Parts;
  struct Close {
    void operator()(Parts* parts) const;
  };
  SdlDisplay(std::unique_ptr<Parts, Close> parts, const ScreenSize& size) : parts_(std::move(parts)), size_(size) {}

  std::unique_ptr<Parts, Close> parts_;
  ScreenSize size_;
};

static_assert(Display<SdlDisplay>);

}  // namespace zstrip::hal
