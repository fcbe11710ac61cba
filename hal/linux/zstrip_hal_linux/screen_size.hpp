// The size of a screen that a user selects.
#pragma once

#include <cstdint>
#include <string>

namespace zstrip::hal {

inline constexpr std::uint16_t kMaxScreen = 4096;  ///< pixels, each side; the limit of zstrip::core

/// Size of a screen, or of one of its modes.
struct ScreenSize {
  std::uint16_t width = 0;   ///< pixels
  std::uint16_t height = 0;  ///< pixels
  friend constexpr bool operator==(const ScreenSize&, const ScreenSize&) = default;
};

/// Formats a size as in "640x480".
inline std::string to_string(const ScreenSize& size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace zstrip::hal
