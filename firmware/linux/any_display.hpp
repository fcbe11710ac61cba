// A display that is known only at run time, with all objects that it needs.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "zstrip_hal/display.hpp"

namespace zstrip::panel {

/// Functions as in hal::Display. When the object ends, a screen gets its former state, and a panel is black and asleep
/// with its backlight off.
class AnyDisplay {
 public:
  AnyDisplay() = default;
  AnyDisplay(const AnyDisplay&) = delete;
  AnyDisplay& operator=(const AnyDisplay&) = delete;
  virtual ~AnyDisplay() = default;

  virtual std::uint16_t width() const = 0;
  virtual std::uint16_t height() const = 0;
  virtual hal::DisplayFormat format() const = 0;
  virtual hal::Error begin_frame() = 0;
  virtual hal::Error write(const hal::Area& area, std::span<const std::byte> pixels) = 0;
  virtual hal::Error wait() = 0;
  virtual hal::Error end_frame() = 0;
  /// Returns a function that is true if the user has closed the display; call it some times a second while the display
  /// lives. Empty if a user cannot close it.
  virtual std::function<bool()> is_closed() { return {}; }
};

static_assert(hal::Display<AnyDisplay>);

/// Forwards all calls to `derived().display()`.
template <class Derived>
class DisplayAdapter : public AnyDisplay {
 public:
  std::uint16_t width() const final { return shown().width(); }
  std::uint16_t height() const final { return shown().height(); }
  hal::DisplayFormat format() const final { return shown().format(); }
  hal::Error begin_frame() final { return shown().begin_frame(); }
  hal::Error write(const hal::Area& area, std::span<const std::byte> pixels) final {
    return shown().write(area, pixels);
  }
  hal::Error wait() final { return shown().wait(); }
  hal::Error end_frame() final { return shown().end_frame(); }

 private:
  auto& shown() { return static_cast<Derived&>(*this).display(); }
  const auto& shown() const { return const_cast<DisplayAdapter*>(this)->shown(); }
};

}  // namespace zstrip::panel
