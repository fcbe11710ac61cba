// The data of the cube: six faces of four vertices, and the checkered, noisy texture.
#include "zstrip_scenes/cube.hpp"

#include "workload_random.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {
namespace {

/// Faces +z, -z, +x, -x, +y, -y; the corners of each counter-clockwise from its lower left.
struct Face {
  std::int8_t normal[3];
  std::int8_t right[3];  ///< the direction in which u grows
  std::int8_t up[3];     ///< the direction in which v grows
};
constexpr Face kFaces[6] = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
                            {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                            {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
constexpr int kCornerU[4] = {0, 1, 1, 0};
constexpr int kCornerV[4] = {0, 0, 1, 1};

consteval std::array<Position, 24> positions() {
  std::array<Position, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Face& face = kFaces[i / 4];
    const int right = 2 * kCornerU[i % 4] - 1, up = 2 * kCornerV[i % 4] - 1;
    const auto corner = [&](int axis) {
      return static_cast<std::int16_t>(32767 * (face.normal[axis] + right * face.right[axis] + up * face.up[axis]));
    };
    result[i] = {corner(0), corner(1), corner(2)};
  }
  return result;
}

consteval std::array<Normal, 24> normals() {
  std::array<Normal, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto component = [&](int axis) { return static_cast<std::int8_t>(127 * kFaces[i / 4].normal[axis]); };  // 1.7
    result[i] = {component(0), component(1), component(2), 0};
  }
  return result;
}

consteval std::array<TexCoord, 24> texcoords() {
  constexpr int kOne = 1 << Mesh{}.texcoord_bits;
  std::array<TexCoord, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = {static_cast<std::int16_t>(kOne * kCornerU[i % 4]), static_cast<std::int16_t>(kOne * kCornerV[i % 4])};
  }
  return result;
}

consteval std::array<Triangle, 12> triangles() {
  std::array<Triangle, 12> result{};
  for (std::size_t face = 0; face < 6; ++face) {
    const auto corner = [face](std::size_t i) { return static_cast<std::uint16_t>(4 * face + i); };
    result[2 * face] = {corner(0), corner(1), corner(2)};
    result[2 * face + 1] = {corner(0), corner(2), corner(3)};
  }
  return result;
}

consteval std::array<std::uint16_t, kCubeTexels.size()> texels() {
  WorkloadRandom random(777);
  std::array<std::uint16_t, kCubeTexels.size()> result{};
  for (std::uint32_t i = 0; i < result.size(); ++i) {
    const std::uint32_t x = i % (1U << kCubeTextureLog2), y = i >> kCubeTextureLog2;
    const std::uint32_t noise = random.next() >> 27;
    const bool warm = ((x ^ y) & 8) != 0;
    const std::uint32_t red = warm ? 31 : noise, green = warm ? 63 - noise : 20, blue = warm ? 10 : 31 - noise;
    result[i] = static_cast<std::uint16_t>(red << 11 | green << 5 | blue);
  }
  return result;
}

}  // namespace

constexpr std::array<Position, 24> kCubePositions = positions();
constexpr std::array<Normal, 24> kCubeNormals = normals();
constexpr std::array<TexCoord, 24> kCubeTexcoords = texcoords();
constexpr std::array<Triangle, 12> kCubeTriangles = triangles();
constexpr std::array<std::uint16_t, kCubeTexels.size()> kCubeTexels = texels();

static_assert(validate(cube.scene));

}  // namespace zstrip::scenes
