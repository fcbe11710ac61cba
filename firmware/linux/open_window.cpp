// Opens a window of the desktop, with SDL.
#include "open_window.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "zstrip_hal_linux/sdl_display.hpp"

namespace zstrip::panel {
namespace {

class Window final : public DisplayAdapter<Window> {
 public:
  explicit Window(hal::SdlDisplay shown) : shown_(std::move(shown)) {}
  hal::SdlDisplay& display() { return shown_; }
  std::function<bool()> is_closed() override {
    return [this] { return shown_.is_closed(); };
  }

 private:
  hal::SdlDisplay shown_;
};

}  // namespace

std::variant<DisplayPointer, Failure> open_window(DisplayAddress& address, const hal::ScreenSize& picture) {
  const auto given = address.take_size("size");
  if (!given) return Failure{ExitStatus::usage, given.fault().message};
  const auto scale = address.take_number("scale", 1, hal::SdlDisplay::kMaxScale);
  if (!scale) return Failure{ExitStatus::usage, scale.fault().message};
  if (const auto untaken = address.untaken()) return Failure{ExitStatus::usage, untaken->message};
  const hal::ScreenSize size = given->value_or(picture);
  const auto factor = static_cast<std::uint16_t>(scale->value_or(1));
  if (std::max(size.width, size.height) * factor > hal::kMaxScreen) {
    const std::string most = std::to_string(hal::kMaxScreen);
    return Failure{ExitStatus::usage,
                   address.fault("scale", "makes a window of more than " + most + " pixels a side").message};
  }
  hal::Outcome<hal::SdlDisplay> shown = hal::SdlDisplay::open("zstrip-panel", size, factor);
  if (!shown) return Failure{ExitStatus::device, shown.fault().message};
  return std::make_unique<Window>(std::move(*shown));
}

}  // namespace zstrip::panel
