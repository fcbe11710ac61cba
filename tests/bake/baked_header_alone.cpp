// What firmware does with a baked header: nothing but the core is included, everything is known to the compiler.
#include "scene.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "baked_alone.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip/scene/validate.hpp"

namespace baked_alone {

#ifdef BAKED_SKINS
constexpr std::uint32_t kMovingDuration = baked::kJointAnimation.duration;
zstrip::Status pose(std::uint32_t milliseconds) { return baked::pose_skins(milliseconds); }
#elif defined(BAKED_MORPHS)
constexpr std::uint32_t kMovingDuration = baked::kWeightAnimation.duration;
zstrip::Status pose(std::uint32_t milliseconds) { return baked::pose_morphs(milliseconds); }
#else
constexpr std::uint32_t kMovingDuration = 0;
zstrip::Status pose(std::uint32_t /*milliseconds*/) { return {}; }
#endif

constexpr Header header{baked::kScene,   baked::kAnimation, baked::kTurn, baked::kCamera,  baked::kView,
                        baked::kEffects, baked::kBudget,    baked::kPlan, kMovingDuration, pose};

zstrip::Status draw(std::span<std::byte> pixels, Send send) {
  if (const zstrip::Status moved = pose(0); !moved) return moved;
  if (const zstrip::Status valid = validate(baked::kScene); !valid) return valid;
  return draw_moved(baked::kScene, baked::kCamera, pixels, send);
}

#ifdef BAKED_CHECKED
alignas(zstrip::kArenaAlignment) std::array<std::byte, baked::kPlan.bytes()> arena;
zstrip::Renderer<baked::kEffects> renderer;

zstrip::Status begin(const zstrip::Scene& scene, const zstrip::Camera& camera) {
#ifdef BAKED_TREE
  renderer.set_visibility({.tree = &baked::kTree});
#endif
  return renderer.begin_frame(scene, camera, baked::kView, baked::kPlan, arena);
}
zstrip::Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
  return renderer.draw_strip(strip, pixels);
}
#else
baked::FixedRenderer renderer;
baked::FixedRenderer::Moving moving;
static_assert(baked::FixedRenderer::kEffects == baked::kEffects);
static_assert(baked::FixedRenderer::kPlan.bytes() == baked::kPlan.bytes());

zstrip::Status begin(const zstrip::Scene& scene, const zstrip::Camera& camera) {
  std::ranges::copy(scene.instances, moving.instances().begin());
  return renderer.begin_frame(camera, moving);
}
zstrip::Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
  return renderer.draw_strip(strip, pixels.first<baked::FixedRenderer::kStripBytes>());
}
#endif

zstrip::Status draw_moved(const zstrip::Scene& scene, const zstrip::Camera& camera, std::span<std::byte> pixels,
                          Send send) {
  const zstrip::Status begun = begin(scene, camera);
  if (!begun) return begun;
  for (std::uint16_t strip = 0; strip < baked::kPlan.strips; ++strip) {
    if (const zstrip::Status drawn = draw_strip(strip, pixels); !drawn) return drawn;
    send(strip, pixels);
  }
  return {};
}

}  // namespace baked_alone
