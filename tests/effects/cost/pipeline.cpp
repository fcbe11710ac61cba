// One pipeline, of COST_EFFECTS and COST_METHODS, and nothing else: linked alone to be weighed, and with draw.cpp to be
// run.
#include "pipeline.hpp"

namespace {

zstrip::Renderer<zstrip::Effects{COST_EFFECTS, COST_METHODS}> renderer;

}  // namespace

extern "C" zstrip::Status cost_begin_frame(const zstrip::Scene& scene, const zstrip::Camera& camera,
                                           const zstrip::View& view, const zstrip::Plan& plan,
                                           std::span<std::byte> arena) {
  return renderer.begin_frame(scene, camera, view, plan, arena);
}

extern "C" zstrip::Status cost_draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
  return renderer.draw_strip(strip, pixels);
}
