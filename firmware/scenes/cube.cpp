// The data of the cube: six faces of four vertices, and the checkered, noisy texture.
#include "zstrip_scenes/cube.hpp"

#include "box_faces.hpp"
#include "workload_random.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {
namespace {

consteval std::array<TexCoord, 24> texcoords() {
  constexpr int kOne = 1 << Mesh{}.texcoord_bits;
  std::array<TexCoord, 24> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = {static_cast<std::int16_t>(kOne * kCornerU[i % 4]), static_cast<std::int16_t>(kOne * kCornerV[i % 4])};
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

constexpr std::array<Position, 24> kCubePositions = box_positions(1);
constexpr std::array<Normal, 24> kCubeNormals = box_normals();
constexpr std::array<TexCoord, 24> kCubeTexcoords = texcoords();
constexpr std::array<Triangle, 12> kCubeTriangles = box_triangles();
constexpr std::array<std::uint16_t, kCubeTexels.size()> kCubeTexels = texels();

static_assert(validate(cube.scene));

}  // namespace zstrip::scenes
