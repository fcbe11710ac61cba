// Replaces open_window.cpp if SDL is missing.
#include "open_window.hpp"

namespace zstrip::panel {

std::variant<DisplayPointer, Failure> open_window(DisplayAddress&, const hal::ScreenSize&) {
  return Failure{ExitStatus::device,
                 "this zstrip-panel was built without windows; install libsdl2-dev and build it again "
                 "(-DZSTRIP_LINUX_WINDOW=ON)"};
}

}  // namespace zstrip::panel
