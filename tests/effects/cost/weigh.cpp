// The pipeline that COST_SCENE needs, and nothing else: linked to be weighed, not to be run.
#include "plain.hpp"
#include "zstrip/zstrip.hpp"

namespace {

using namespace zstrip;

Renderer<effects_cost::kEffectsOf<scenes::COST_SCENE, COST_PLAIN>> renderer;

}  // namespace

extern "C" Status weighed_begin_frame(const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                                      std::span<std::byte> arena) {
  return renderer.begin_frame(scene, camera, view, plan, arena);
}

extern "C" Status weighed_draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
  return renderer.draw_strip(strip, pixels);
}
