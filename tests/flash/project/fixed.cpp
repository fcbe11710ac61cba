// Scene, picture and plan are known when it is compiled; with FLASH_UNCLIPPED nothing comes near the camera.
#include <array>
#include <cstddef>
#include <cstdint>

#include "drawn.hpp"

namespace {

constexpr zstrip::Effects kMore = FLASH_UNCLIPPED ? zstrip::effect::unclipped : zstrip::Effects{};
zstrip::FixedRenderer<kScene, kView, kBudget, kMore, zstrip::Projection::perspective, kCounts> renderer;
alignas(2) std::array<std::byte, renderer.kStripBytes> pixels;

}  // namespace

int main() {
  zstrip::Camera camera;
  learn_at_run_time(camera);
  if (!renderer.begin_frame(camera)) return 1;
  for (std::uint16_t strip = 0; strip < renderer.kPlan.strips; ++strip) {
    if (!renderer.draw_strip(strip, pixels)) return 1;
    learn_at_run_time(pixels);
  }
  return 0;
}
