// Opens the display that an address names: screens here, panels in open_panel.cpp, windows in open_window.cpp.
#include "open_display.hpp"

#include <cstdio>
#include <type_traits>
#include <utility>
#include <vector>

#include "open_panel.hpp"
#include "open_window.hpp"
#include "zstrip_hal_linux/drm_display.hpp"
#include "zstrip_hal_linux/framebuffer_display.hpp"
#include "zstrip_hal_linux/graphics_console.hpp"
#include "zstrip_hal_linux/mirrored_displays.hpp"

namespace zstrip::panel {
namespace {

using hal::Outcome;

Failure usage(const hal::Fault& fault) { return {ExitStatus::usage, fault.message}; }
Failure device(const hal::Fault& fault) { return {ExitStatus::device, fault.message}; }

/// A screen of the machine, whose text console does not draw meanwhile.
template <class Shown>
class Screen final : public DisplayAdapter<Screen<Shown>> {
 public:
  Screen(hal::GraphicsConsole console, Shown shown) : console_(std::move(console)), shown_(std::move(shown)) {}
  Shown& display() { return shown_; }

 private:
  // In this order: the console is restored after the screen.
  hal::GraphicsConsole console_;
  Shown shown_;
};

/// Takes the console. Without permission pictures can be shown, but the console may draw over them.
hal::GraphicsConsole take_console() {
  Outcome<hal::GraphicsConsole> console = hal::GraphicsConsole::enter();
  if (console) return std::move(*console);
  std::fprintf(stderr, "zstrip-panel: %s; its text may appear on the picture\n", console.fault().message.c_str());
  return hal::GraphicsConsole();
}

/// Takes the console before the screen: it stores the mode that it finds, and restores it.
template <class Open>
std::variant<DisplayPointer, Failure> open_screen(Open open) {
  hal::GraphicsConsole console = take_console();
  auto shown = open();
  if (!shown) return device(shown.fault());
  using Shown = std::remove_reference_t<decltype(*shown)>;
  return std::make_unique<Screen<Shown>>(std::move(console), std::move(*shown));
}

Outcome<hal::MirroredDisplays<hal::DrmDisplay>> open_all(const std::string& path, const hal::DrmOptions& options) {
  Outcome<std::vector<hal::DrmDisplay>> displays = hal::DrmDisplay::open_all(path, options);
  if (!displays) return displays.fault();
  return hal::MirroredDisplays(std::move(*displays));
}

std::variant<DisplayPointer, Failure> open_framebuffer(DisplayAddress& address) {
  const auto size = address.take_size("size");
  if (!size) return usage(size.fault());
  const auto depth = address.take_number("depth", 16, 32);
  if (!depth) return usage(depth.fault());
  if (depth->value_or(16) % 8 != 0) return usage(address.fault("depth", "is 16, 24 or 32"));
  if (const auto untaken = address.untaken()) return usage(*untaken);
  const std::string path = address.device().empty() ? "/dev/fb0" : address.device();
  const hal::FramebufferOptions options{*size, *depth};
  return open_screen([&] { return hal::FramebufferDisplay::open(path, options); });
}

std::variant<DisplayPointer, Failure> open_card(DisplayAddress& address) {
  hal::DrmOptions options;
  const auto size = address.take_size("size");
  if (!size) return usage(size.fault());
  options.size = *size;
  const auto connector = address.take_name("connector");
  if (!connector) return usage(connector.fault());
  options.connector = connector->value_or("");
  if (const auto format = address.take("format")) {
    if (*format != "rgb565" && *format != "xrgb8888")
      return usage(address.fault("format", "is rgb565 or xrgb8888, not '" + *format + "'"));
    options.format = *format == "rgb565" ? hal::DrmFormat::rgb565 : hal::DrmFormat::xrgb8888;
  }
  if (const auto untaken = address.untaken()) return usage(*untaken);
  const std::string path = address.device().empty() ? "/dev/dri/card0" : address.device();
  if (options.connector == "all") return open_screen([&] { return open_all(path, options); });
  return open_screen([&] { return hal::DrmDisplay::open(path, options); });
}

}  // namespace

std::variant<DisplayPointer, Failure> open_display(const std::string& text, const hal::ScreenSize& picture) {
  // "sdl:" alone is a window with default settings.
  Outcome<DisplayAddress> address = DisplayAddress::parse(text == "sdl:" ? "sdl" : text);
  if (!address) return usage(address.fault());
  if (address->kind() == "fbdev") return open_framebuffer(*address);
  if (address->kind() == "drm") return open_card(*address);
  if (const auto refused = address->refused_device(); refused && address->kind() == "sdl") return usage(*refused);
  if (address->kind() == "sdl") return open_window(*address, picture);
  return open_panel(*address);
}

}  // namespace zstrip::panel
