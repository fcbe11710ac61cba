// Only the effects are known when it is compiled: scene, picture and plan are checked when it runs.
#include <array>
#include <cstddef>
#include <cstdint>

#include "drawn.hpp"

namespace {

constexpr zstrip::Effects kEffects = zstrip::effects_of(kScene, zstrip::Camera{});
constexpr zstrip::Plan kPlan = zstrip::plan(kCounts, kView, kEffects, kBudget).plan;
alignas(zstrip::kArenaAlignment) std::array<std::byte, kPlan.bytes()> arena;
alignas(2) std::array<std::byte, kPlan.strip_pixel_bytes(kView)> pixels;
zstrip::Renderer<kEffects> renderer;

}  // namespace

int main() {
  const zstrip::Scene* scene = &kScene;
  const zstrip::View* view = &kView;
  const zstrip::Plan* plan = &kPlan;
  zstrip::Camera camera;
  learn_at_run_time(scene);
  learn_at_run_time(view);
  learn_at_run_time(plan);
  learn_at_run_time(camera);
  if (!renderer.begin_frame(*scene, camera, *view, *plan, arena)) return 1;
  for (std::uint16_t strip = 0; strip < plan->strips; ++strip) {
    if (!renderer.draw_strip(strip, pixels)) return 1;
    learn_at_run_time(pixels);
  }
  return 0;
}
