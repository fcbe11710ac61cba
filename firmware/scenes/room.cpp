// The data of the room's walls: a box whose faces look inwards, and its tiles.
#include "zstrip_scenes/room.hpp"

#include "box_faces.hpp"

namespace zstrip::scenes {
namespace {

/// The number of tiles on a wall, in the order of kBoxFaces.
struct Tiles {
  int across, up;
};
constexpr Tiles kTiles[6] = {{4, 2}, {4, 2}, {4, 2}, {4, 2}, {4, 4}, {4, 4}};

/// v grows downwards and is 0 at the upper edge of a wall.
consteval std::array<TexCoord, 24> texcoords() {
  constexpr int kOne = 1 << Mesh{}.texcoord_bits;
  std::array<TexCoord, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Tiles& tiles = kTiles[i / 4];
    result[i] = {static_cast<std::int16_t>(kOne * tiles.across * kCornerU[i % 4]),
                 static_cast<std::int16_t>(kOne * tiles.up * (1 - kCornerV[i % 4]))};
  }
  return result;
}

/// Returns two light and two darker tiles with joints between them.
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

constexpr std::array<Position, 24> kRoomPositions = box_positions(-1);
constexpr std::array<Normal, 24> kRoomNormals = box_normals();
constexpr std::array<TexCoord, 24> kRoomTexcoords = texcoords();
constexpr std::array<Triangle, 12> kRoomTriangles = box_triangles();
constexpr std::array<std::uint16_t, kRoomTexels.size()> kRoomTexels = texels();

}  // namespace zstrip::scenes
