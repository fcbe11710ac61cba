// The texels of all textures of the contracts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "random.hpp"

namespace zstrip::kernels_test {

inline constexpr std::int32_t kMaxLog2Width = 9, kMaxLog2Height = 8;
inline std::array<std::uint16_t, std::size_t{1} << (kMaxLog2Width + kMaxLog2Height)> texels;

inline void fill_texels(Random& random) {
  for (std::uint16_t& texel : texels) texel = static_cast<std::uint16_t>(random.word() >> 16);
}

}  // namespace zstrip::kernels_test
