// The size of a screen that a user selects.
#pragma once

#include <cstdint>
#include <string>

namespace zstrip::hal {

inline constexpr std::uint16_t kMaxScreen = 4096;  ///< pixels, each side; what zstrip::core draws

struct ScreenSize {
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  friend constexpr bool operator==(const ScreenSize&, const ScreenSize&) = default;
};

inline std::string to_string(const ScreenSize& size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace zstrip::hal
