// Colours written as hexadecimal digits.
#include "text/colour.hpp"

#include <array>
#include <charconv>
#include <cstdint>

namespace zstrip::sim {

std::optional<Colour> parse_colour(std::string_view digits) {
  if (digits.size() != 6) return std::nullopt;
  std::array<std::uint8_t, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    const char* const begin = digits.data() + 2 * i;
    const auto [end, error] = std::from_chars(begin, begin + 2, channels[i], 16);
    if (error != std::errc() || end != begin + 2) return std::nullopt;
  }
  return Colour{channels[0], channels[1], channels[2], 255};
}

}  // namespace zstrip::sim
