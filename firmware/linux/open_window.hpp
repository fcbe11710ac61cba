// Opens a window of the desktop.
#pragma once

#include <variant>

#include "open_display.hpp"

namespace zstrip::panel {

/// Does the same as open_display, for an address of the kind "sdl". `picture`: the size, unless the address has one.
std::variant<DisplayPointer, Failure> open_window(DisplayAddress& address, const hal::ScreenSize& picture);

}  // namespace zstrip::panel
