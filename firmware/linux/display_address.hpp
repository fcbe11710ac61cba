// The text with which a user names a display: KIND:KEY=VALUE,..., with the device first if the display is one file.
//   fbdev:/dev/fb0,size=640x480
//   drm:/dev/dri/card0,connector=HDMI-A-1
//   sdl:640x480@2, which is sdl,size=640x480,scale=2, and sdl:@2
//   st7789:spidev=/dev/spidev0.0,dc=gpiochip0:25,reset=RESET
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "zstrip_hal_linux/outcome.hpp"
#include "zstrip_hal_linux/screen_size.hpp"

namespace zstrip::panel {

class DisplayAddress {
 public:
  /// Faults name what is wrong with the text.
  static hal::Outcome<DisplayAddress> parse(const std::string& text);

  const std::string& kind() const { return kind_; }
  /// Returns the value without a key, the device. Empty: none.
  const std::string& device() const { return device_; }

  /// These take a key's value. Keys that are not taken are unknown: see untaken().
  std::optional<std::string> take(const std::string& key);
  /// The value must be a name: not empty, and not a key without a value.
  hal::Outcome<std::optional<std::string>> take_name(const std::string& key);
  hal::Outcome<std::optional<hal::ScreenSize>> take_size(const std::string& key);
  /// The value must be from `least` to `most`; K, M and G multiply by powers of 1000.
  hal::Outcome<std::optional<std::uint32_t>> take_number(const std::string& key, std::uint32_t least,
                                                         std::uint32_t most);
  /// The key must have no value, or the value "yes" or "no".
  hal::Outcome<bool> take_flag(const std::string& key, bool unless_given = false);
  /// Returns a fault that names an unknown key, if there is one.
  std::optional<hal::Fault> untaken() const;

  hal::Fault fault(const std::string& key, const std::string& what) const;
  /// Returns a fault if there is a device: for displays that have none, so that it is not ignored.
  std::optional<hal::Fault> refused_device() const;

 private:
  std::string kind_;
  std::string device_;
  std::map<std::string, std::optional<std::string>, std::less<>> values_;  ///< no value: a key without one
};

}  // namespace zstrip::panel
