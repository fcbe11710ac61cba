// A fixed renderer without clipping: linked to be looked at by absence_test.cpp, not to be run for its picture.
#include <array>
#include <cstddef>
#include <cstdint>

#include "zstrip/zstrip.hpp"
#include "zstrip_scenes/cube.hpp"

namespace {

constexpr zstrip::Scene kScene = zstrip::scenes::cube.scene;
constexpr zstrip::View kView{64, 48, zstrip::PixelFormat::rgb565_swapped};
zstrip::FixedRenderer<kScene, kView, zstrip::Budget{.strip_rows = 8}, zstrip::effect::unclipped> renderer;
alignas(2) std::array<std::byte, renderer.kStripBytes> pixels;

}  // namespace

int main() {
  if (!renderer.begin_frame(zstrip::scenes::cube.camera)) return 1;
  for (std::uint16_t strip = 0; strip < renderer.kPlan.strips; ++strip) {
    if (!renderer.draw_strip(strip, pixels)) return 1;
  }
  return 0;
}
