// The data of the room's walls: a box whose faces look inwards, and its tiles.
#include "zstrip_scenes/room.hpp"

namespace zstrip::scenes {
namespace {

/// The inward normal; the corners of each wall counter-clockwise, seen from inside, from its lower left.
struct Wall {
  std::int8_t normal[3];
  std::int8_t right[3];
  std::int8_t up[3];
  std::int8_t tiles_across, tiles_up;
};
constexpr Wall kWalls[6] = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 4, 2},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}, 4, 2},
                            {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, 4, 2}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 4, 2},
                            {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, 4, 4}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}, 4, 4}};
constexpr int kCornerU[4] = {0, 1, 1, 0};
constexpr int kCornerV[4] = {0, 0, 1, 1};

consteval std::array<Position, 24> positions() {
  std::array<Position, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Wall& wall = kWalls[i / 4];
    const int right = 2 * kCornerU[i % 4] - 1, up = 2 * kCornerV[i % 4] - 1;
    const auto corner = [&](int axis) {
      return static_cast<std::int16_t>(32767 * (right * wall.right[axis] + up * wall.up[axis] - wall.normal[axis]));
    };
    result[i] = {corner(0), corner(1), corner(2)};
  }
  return result;
}

consteval std::array<Normal, 24> normals() {
  std::array<Normal, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto component = [&](int axis) { return static_cast<std::int8_t>(127 * kWalls[i / 4].normal[axis]); };  // 1.7
    result[i] = {component(0), component(1), component(2), 0};
  }
  return result;
}

/// v grows downwards: 0 at the upper edge of a wall.
consteval std::array<TexCoord, 24> texcoords() {
  constexpr int kOne = 1 << Mesh{}.texcoord_bits;
  std::array<TexCoord, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Wall& wall = kWalls[i / 4];
    result[i] = {static_cast<std::int16_t>(kOne * wall.tiles_across * kCornerU[i % 4]),
                 static_cast<std::int16_t>(kOne * wall.tiles_up * (1 - kCornerV[i % 4]))};
  }
  return result;
}

consteval std::array<Triangle, 12> triangles() {
  std::array<Triangle, 12> result{};
  for (std::size_t wall = 0; wall < 6; ++wall) {
    const auto corner = [wall](std::size_t i) { return static_cast<std::uint16_t>(4 * wall + i); };
    result[2 * wall] = {corner(0), corner(1), corner(2)};
    result[2 * wall + 1] = {corner(0), corner(2), corner(3)};
  }
  return result;
}

/// Two light and two darker tiles with joints between them.
consteval std::array<std::uint16_t, kRoomTexels.size()> texels() {
  constexpr std::uint16_t kJoint = 0x8C71, kLight = 0xF7BE, kDark = 0xC5F6;  // RGB565
  std::array<std::uint16_t, kRoomTexels.size()> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::size_t x = i % (1U << kRoomTextureLog2), y = i >> kRoomTextureLog2;
    const bool joint = x % 8 == 7 || y % 8 == 7;
    result[i] = joint ? kJoint : ((x ^ y) & 8) != 0 ? kDark : kLight;
  }
  return result;
}

}  // namespace

constexpr std::array<Position, 24> kRoomPositions = positions();
constexpr std::array<Normal, 24> kRoomNormals = normals();
constexpr std::array<TexCoord, 24> kRoomTexcoords = texcoords();
constexpr std::array<Triangle, 12> kRoomTriangles = triangles();
constexpr std::array<std::uint16_t, kRoomTexels.size()> kRoomTexels = texels();

}  // namespace zstrip::scenes
