// What firmware does with a baked header: nothing but the core is included, everything is known to the compiler.
#include "scene.hpp"

#include <array>
#include <cstddef>

#include "zstrip/frame/renderer.hpp"
#include "zstrip/scene/validate.hpp"

namespace baked_alone {

alignas(zstrip::kArenaAlignment) std::array<std::byte, baked::kPlan.bytes()> arena;
zstrip::Renderer<baked::kEffects> renderer;

/// Draws the picture; `send` gets each strip.
zstrip::Status draw(std::span<std::byte> pixels, void (*send)(std::uint16_t strip, std::span<const std::byte> pixels)) {
  if (const zstrip::Status valid = validate(baked::kScene); !valid) return valid;
#ifdef BAKED_TREE
  renderer.set_visibility({.tree = &baked::kTree});
#endif
  const zstrip::Status begun = renderer.begin_frame(baked::kScene, baked::kCamera, baked::kView, baked::kPlan, arena);
  if (!begun) return begun;
  for (std::uint16_t strip = 0; strip < baked::kPlan.strips; ++strip) {
    if (const zstrip::Status drawn = renderer.draw_strip(strip, pixels); !drawn) return drawn;
    send(strip, pixels);
  }
  return {};
}

}  // namespace baked_alone
