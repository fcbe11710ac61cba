// The pipeline of workload K5 alone. It is linked to measure its size (tests/instruction-budget), not to run.
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/renderer.hpp"
#include "zstrip_scenes/knot.hpp"

namespace {

constexpr zstrip::Effects kEffects = effects_of(zstrip::scenes::knot.scene, zstrip::scenes::knot.camera);
zstrip::Renderer<kEffects> renderer;

}  // namespace

extern "C" zstrip::Status pipeline_begin_frame(const zstrip::Scene& scene, const zstrip::Camera& camera,
                                               const zstrip::View& view, const zstrip::Plan& plan,
                                               std::span<std::byte> arena) {
  return renderer.begin_frame(scene, camera, view, plan, arena);
}

extern "C" zstrip::Status pipeline_draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
  return renderer.draw_strip(strip, pixels);
}
