// The globe's texture: meridians and parallels, bluer towards the lower pole.
#include "zstrip_scenes/spheres.hpp"

namespace zstrip::scenes {
namespace {

consteval std::array<std::uint16_t, kGlobeTexels.size()> texels() {
  std::array<std::uint16_t, kGlobeTexels.size()> result{};
  for (std::uint32_t i = 0; i < result.size(); ++i) {
    const std::uint32_t x = i % (1U << kGlobeTextureLog2[0]), y = i >> kGlobeTextureLog2[0];
    const bool dark = ((x >> 1 ^ y >> 1) & 1) != 0;
    const std::uint32_t red = dark ? 8 : 31, green = dark ? 16 : 63 - 2 * y, blue = dark ? 10 + y : 31;
    result[i] = static_cast<std::uint16_t>(red << 11 | green << 5 | blue);
  }
  return result;
}

}  // namespace

constexpr std::array<std::uint16_t, kGlobeTexels.size()> kGlobeTexels = texels();

}  // namespace zstrip::scenes
