// The list of the effects' scenes, and the lattice.
#include "zstrip_scenes/effect_scenes.hpp"

namespace zstrip::scenes {
namespace {

constexpr BuiltIn kEffectScenes[] = {fog, emissive, specular, punctual, mask, blend, bilinear};

consteval bool all_valid() {
  for (const BuiltIn& scene : kEffectScenes) {
    if (scene.scene.instances.size() > kMaxInstances) return false;
  }
  return true;
}
static_assert(all_valid());

consteval std::array<std::uint16_t, 256 + 128> lattice() {
  std::array<std::uint16_t, 256 + 128> result{};
  for (std::size_t i = 0; i < 256; ++i) {
    const std::size_t x = i % 16, y = i / 16;
    const bool bar = x % 8 < 3 || y % 8 < 3;
    result[i] = x % 8 == 0 || y % 8 == 0 ? 0xFE60 : 0xC480;  // RGB565: brass, lighter at the edges
    if (bar) result[256 + i / 2] |= static_cast<std::uint16_t>(i % 2 == 0 ? 0x00FF : 0xFF00);
  }
  return result;
}

}  // namespace

constexpr std::array<std::uint16_t, 256 + 128> kLatticeTexels = lattice();

std::span<const BuiltIn> effect_scenes() { return kEffectScenes; }

}  // namespace zstrip::scenes
