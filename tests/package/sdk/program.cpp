// A triangle that a panel on pins shows: needs both libraries, and nothing else.
#include <zstrip.h>

namespace {

constexpr zstrip::Position kPositions[]{{0, 32767, 0}, {-32767, -32767, 0}, {32767, -32767, 0}};
constexpr zstrip::Triangle kTriangles[]{{0, 1, 2}};
constexpr zstrip::Mesh kMeshes[]{
    {.positions = kPositions, .normals = {}, .colours = {}, .texcoords = {}, .triangles = kTriangles, .meshlets = {}}};
constexpr zstrip::Material kMaterials[]{{.colour = {255, 0, 0, 255}, .lit = false}};
constexpr zstrip::Instance kInstances[]{{.mesh = 0, .material = 0}};
constexpr zstrip::Scene kScene{
    .meshes = kMeshes, .materials = kMaterials, .textures = {}, .instances = kInstances, .lights = {}};

constexpr zstrip::View kView{240, 240, zstrip::PixelFormat::rgb565_swapped};
zstrip::FixedRenderer<kScene, kView, zstrip::Budget{.bytes = 8192}> renderer;
alignas(4) std::byte pixels[renderer.kStripBytes];

volatile std::uint32_t lines;  // of a port

struct Pin {
  std::uint32_t bit;
  zstrip::hal::Error set(bool high) const {
    lines = high ? lines | bit : lines & ~bit;
    return zstrip::hal::Error::none;
  }
};
struct Clock {
  void wait(std::uint32_t microseconds) const {
    for (volatile std::uint32_t count = microseconds; count != 0;) count = count - 1;
  }
};

}  // namespace

int main() {
  zstrip::hal::BitBangedSpi bus(Pin{1}, Pin{2}, Pin{4}, Pin{8});
  Clock clock;
  zstrip::hal::St7789 panel(bus, clock);
  if (bus.start() != zstrip::hal::Error::none || panel.start() != zstrip::hal::Error::none) return 1;
  if (!renderer.begin_frame(zstrip::Camera{})) return 1;
  return zstrip::hal::present(renderer, panel, {renderer.kPlan.strips, renderer.kPlan.strip_rows}, {pixels, {}}) ? 0
                                                                                                                 : 1;
}
