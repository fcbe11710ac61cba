// Multiplies a light's colour by a material's.
#pragma once

#include <cstdint>

#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Multiplies channel by channel, with 255 as one, rounded to nearest; the result is opaque.
constexpr Colour product(const Colour& a, const Colour& b) {
  const auto channel = [](std::uint8_t p, std::uint8_t q) { return static_cast<std::uint8_t>((p * q + 127) / 255); };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), 255};
}

}  // namespace zstrip::detail
