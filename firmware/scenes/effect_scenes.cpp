// The list of the effects' scenes, the lattice, tiles with a palette, a floor with mipmaps, and an environment map.
#include "zstrip_scenes/effect_scenes.hpp"

namespace zstrip::scenes {
namespace {

constexpr BuiltIn kEffectScenes[] = {fog,      emissive, specular, punctual,    mask,     blend,
                                     bilinear, palette,  mipmaps,  environment, per_pixel};

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

/// Returns joints, light and dark tiles, as in room.cpp, as indices.
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

/// Returns levels in which half of the texels are light, down to one texel with the mean.
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

constexpr std::int32_t root(std::int32_t square) {
  std::int32_t root = 0;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

/// `share` is the share of `to`, in 1/256.
consteval std::uint16_t mixed(const Colour& from, const Colour& to, std::int32_t share) {
  const auto channel = [share](std::int32_t a, std::int32_t b) {
    return a + (b - a) * (share < 256 ? share : 256) / 256;
  };
  return static_cast<std::uint16_t>(channel(from.r, to.r) >> 3 << 11 | channel(from.g, to.g) >> 2 << 5 |
                                    channel(from.b, to.b) >> 3);
}

/// Returns the reflection on a ball of radius 31, under a sky that is blue above, over a floor that is dark far away.
consteval std::array<std::uint16_t, 1024> environment_map() {
  std::array<std::uint16_t, 1024> result{};
  for (std::int32_t i = 0; i < 1024; ++i) {
    const std::int32_t x = 2 * (i % 32) - 31, y = 31 - 2 * (i / 32), square = 31 * 31 - x * x - y * y;
    const std::int32_t height = 2 * y * root(square > 0 ? square : 0) * 256 / (31 * 31);
    const bool frame = x == -11 || y == 11;
    std::uint16_t& texel = result[static_cast<std::size_t>(i)];
    if (x > -17 && x < -5 && y > 5 && y < 17 && !frame) {
      texel = 0xFFFF;
    } else if (y > 0) {
      texel = mixed({224, 232, 240, 255}, {56, 96, 168, 255}, height * 5 / 4);
    } else {
      texel = mixed({40, 30, 28, 255}, {168, 132, 96, 255}, -height);
    }
  }
  return result;
}

/// A point of the octahedron |x| + |y| + |z| = kCuts.
struct OctahedronPoint {
  std::int32_t x, y, z;
};
constexpr std::int32_t kCuts = 4;

consteval std::array<OctahedronPoint, kBallVertices> octahedron() {
  std::array<OctahedronPoint, kBallVertices> points{};
  std::size_t count = 0;
  for (std::int32_t x = -kCuts; x <= kCuts; ++x) {
    const std::int32_t rest = kCuts - (x < 0 ? -x : x);
    for (std::int32_t y = -rest; y <= rest; ++y) {
      const std::int32_t z = rest - (y < 0 ? -y : y);
      points[count++] = {x, y, z};
      if (z != 0) points[count++] = {x, y, -z};
    }
  }
  return points;
}

/// Returns the coordinate on the sphere of this radius for `coordinate` on the octahedron, rounded to nearest.
constexpr std::int32_t on_sphere(std::int32_t coordinate, const OctahedronPoint& p, std::int32_t radius) {
  const std::int32_t length = root((p.x * p.x + p.y * p.y + p.z * p.z) << 16);  // 8 fraction bits
  const std::int32_t twice = 2 * 256 * radius * coordinate / length;
  return (twice + (twice < 0 ? -1 : 1)) / 2;
}

consteval std::array<Position, kBallVertices> ball_positions() {
  std::array<Position, kBallVertices> result{};
  for (std::size_t i = 0; i < kBallVertices; ++i) {
    const OctahedronPoint p = octahedron()[i];
    const auto at = [&p](std::int32_t c) { return static_cast<std::int16_t>(on_sphere(c, p, 32766)); };
    result[i] = {at(p.x), at(p.y), at(p.z)};
  }
  return result;
}

consteval std::array<Normal, kBallVertices> ball_normals() {
  std::array<Normal, kBallVertices> result{};
  for (std::size_t i = 0; i < kBallVertices; ++i) {
    const OctahedronPoint p = octahedron()[i];
    const auto at = [&p](std::int32_t c) { return static_cast<std::int8_t>(on_sphere(c, p, 127)); };
    result[i] = {at(p.x), at(p.y), at(p.z), 0};
  }
  return result;
}

consteval std::array<Triangle, kBallTriangleCount> ball_triangles() {
  constexpr auto kPoints = octahedron();
  std::array<Triangle, kBallTriangleCount> result{};
  std::size_t count = 0;
  for (std::int32_t octant = 0; octant < 8; ++octant) {
    const std::int32_t sx = (octant & 1) != 0 ? -1 : 1, sy = (octant & 2) != 0 ? -1 : 1,
                       sz = (octant & 4) != 0 ? -1 : 1;
    const auto index = [&](std::int32_t a, std::int32_t b) {
      std::uint16_t i = 0;
      while (kPoints[i].x != sx * a || kPoints[i].y != sy * b || kPoints[i].z != sz * (kCuts - a - b)) ++i;
      return i;
    };
    const auto add = [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) {
      result[count++] = sx * sy * sz > 0 ? Triangle{a, b, c} : Triangle{a, c, b};
    };
    for (std::int32_t a = 0; a < kCuts; ++a) {
      for (std::int32_t b = 0; a + b < kCuts; ++b) {
        add(index(a, b), index(a + 1, b), index(a, b + 1));
        if (a + b + 1 < kCuts) add(index(a + 1, b), index(a + 1, b + 1), index(a, b + 1));
      }
    }
  }
  return result;
}

}  // namespace

constexpr std::array<Position, kBallVertices> kBallPositions = ball_positions();
constexpr std::array<Normal, kBallVertices> kBallNormals = ball_normals();
constexpr std::array<Triangle, kBallTriangleCount> kBallTriangles = ball_triangles();

constexpr std::array<std::uint16_t, 1024> kEnvironmentTexels = environment_map();

constexpr std::array<std::uint16_t, 256 + 64 + 16 + 4 + 1> kChequerTexels = chequer();
constexpr std::array<Position, 4> kFloorPositions = {
    {{-32767, 0, 32767}, {32767, 0, 32767}, {32767, 0, -32767}, {-32767, 0, -32767}}};
constexpr std::array<TexCoord, 4> kFloorTexcoords = {{{0, 24 << 10}, {4 << 10, 24 << 10}, {4 << 10, 0}, {0, 0}}};
constexpr std::array<Triangle, 2> kFloorTriangles = {{{0, 1, 2}, {0, 2, 3}}};

constexpr std::array<std::uint16_t, 256 + 128> kLatticeTexels = lattice();
constexpr std::array<std::uint16_t, 16 + 64> kIndexedTexels = indexed();

std::span<const BuiltIn> effect_scenes() { return kEffectScenes; }

}  // namespace zstrip::scenes
