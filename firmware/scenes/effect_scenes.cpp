// The list of the effects' scenes, the lattice, tiles with a palette, and a floor with mipmaps.
#include "zstrip_scenes/effect_scenes.hpp"

namespace zstrip::scenes {
namespace {

constexpr BuiltIn kEffectScenes[] = {fog, emissive, specular, punctual, mask, blend, bilinear, palette, mipmaps};

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

/// As the texels of room.cpp: joints, light and dark tiles.
consteval std::array<std::uint16_t, 16 + 64> indexed() {
  std::array<std::uint16_t, 16 + 64> result{0x8C71, 0xF7BE, 0xC5F6};  // RGB565
  for (std::size_t i = 0; i < 256; ++i) {
    const std::size_t x = i % 16, y = i / 16;
    const bool joint = x % 8 == 7 || y % 8 == 7;
    const unsigned index = joint ? 0 : ((x ^ y) & 8) != 0 ? 2 : 1;
    result[16 + i / 4] |= static_cast<std::uint16_t>(index << 4 * (i % 4));
  }
  return result;
}

/// Half of each level's texels are light, down to one texel between both.
consteval std::array<std::uint16_t, 256 + 64 + 16 + 4 + 1> chequer() {
  constexpr std::uint16_t kLight = 0xFFFF, kDark = 0x18E8, kBetween = 0x8C74;  // RGB565
  std::array<std::uint16_t, 256 + 64 + 16 + 4 + 1> result{};
  std::size_t at = 0;
  for (std::size_t side = 16; side > 1; side /= 2) {
    for (std::size_t i = 0; i < side * side; ++i) {
      const bool light = ((i % side < side / 2) != (i / side < side / 2));
      result[at++] = light ? kLight : kDark;
    }
  }
  result[at] = kBetween;
  return result;
}

}  // namespace

constexpr std::array<std::uint16_t, 256 + 64 + 16 + 4 + 1> kChequerTexels = chequer();
constexpr std::array<Position, 4> kFloorPositions = {
    {{-32767, 0, 32767}, {32767, 0, 32767}, {32767, 0, -32767}, {-32767, 0, -32767}}};
constexpr std::array<TexCoord, 4> kFloorTexcoords = {{{0, 24 << 10}, {4 << 10, 24 << 10}, {4 << 10, 0}, {0, 0}}};
constexpr std::array<Triangle, 2> kFloorTriangles = {{{0, 1, 2}, {0, 2, 3}}};

constexpr std::array<std::uint16_t, 256 + 128> kLatticeTexels = lattice();
constexpr std::array<std::uint16_t, 16 + 64> kIndexedTexels = indexed();

std::span<const BuiltIn> effect_scenes() { return kEffectScenes; }

}  // namespace zstrip::scenes
