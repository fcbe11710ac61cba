// Opens the display that an address names.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "any_display.hpp"
#include "display_address.hpp"
#include "exit_status.hpp"

namespace zstrip::panel {

using DisplayPointer = std::unique_ptr<AnyDisplay>;

/// Returns a display that was started and is black. Failures: usage, device, output (a panel that cannot be started).
/// `picture`: the size of a window, unless the address has one.
std::variant<DisplayPointer, Failure> open_display(const std::string& address, const hal::ScreenSize& picture);

}  // namespace zstrip::panel
