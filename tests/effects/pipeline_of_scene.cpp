// The one pipeline that EFFECT_SCENE calls for, in EFFECT_FORMAT, dithered if EFFECT_DITHER, with EFFECT_SAMPLES a
// pixel: linked to be looked at by absence_test.cpp, not to be run for its picture.
#include "pipeline_headers.hpp"

namespace {

constexpr const zstrip::scenes::BuiltIn& kBuiltIn = zstrip::scenes::EFFECT_SCENE;
constexpr zstrip::View kView{64, 48, zstrip::PixelFormat::EFFECT_FORMAT, EFFECT_DITHER, EFFECT_SAMPLES};
constexpr zstrip::Effects kEffects = effects_of(kBuiltIn.scene, kBuiltIn.camera) | effects_of(kView);
constexpr zstrip::Plan kPlan = plan(kBuiltIn.counts, kView, kEffects, {.strip_rows = 16}).plan;
alignas(zstrip::kArenaAlignment) std::array<std::byte, kPlan.bytes()> arena;
alignas(4) std::array<std::byte, kPlan.strip_pixel_bytes(kView)> pixels;
zstrip::Renderer<kEffects> renderer;

}  // namespace

int main() {
  if (!renderer.begin_frame(kBuiltIn.scene, kBuiltIn.camera, kView, kPlan, arena)) return 1;
  for (std::uint16_t strip = 0; strip < kPlan.strips; ++strip) {
    if (!renderer.draw_strip(strip, pixels)) return 1;
  }
  return 0;
}
