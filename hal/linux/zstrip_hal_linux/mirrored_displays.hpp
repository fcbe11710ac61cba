// Shows one picture on several displays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "zstrip_hal/display.hpp"

namespace zstrip::hal {

/// Needs at least one display; all have one size and format. Each call goes to every display, also after an error of
/// one of them, and returns the first error.
template <Display Shown>
class MirroredDisplays {
 public:
  explicit MirroredDisplays(std::vector<Shown> displays) : displays_(std::move(displays)) {}

  /// @{
  /// See the concept Display.
  std::uint16_t width() const { return displays_.front().width(); }
  std::uint16_t height() const { return displays_.front().height(); }
  DisplayFormat format() const { return displays_.front().format(); }

  Error begin_frame() {
    return on_all([](Shown& display) { return display.begin_frame(); });
  }
  Error write(const Area& area, std::span<const std::byte> pixels) {
    return on_all([&](Shown& display) { return display.write(area, pixels); });
  }
  Error wait() {
    return on_all([](Shown& display) { return display.wait(); });
  }
  Error end_frame() {
    return on_all([](Shown& display) { return display.end_frame(); });
  }
  /// @}

 private:
  template <class Function>
  Error on_all(Function function) {
    Error first = Error::none;
    for (Shown& display : displays_) {
      const Error error = function(display);
      if (first == Error::none) first = error;
    }
    return first;
  }

  std::vector<Shown> displays_;
};

}  // namespace zstrip::hal
