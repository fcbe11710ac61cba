// Computes the position of the teapot.
#include "zstrip_scenes/showroom.hpp"

#include "zstrip/base/math.hpp"

namespace zstrip::scenes {

Instance showroom_teapot(std::uint32_t frame, std::uint32_t frames) {
  constexpr Fixed kRadius = fixed(0.8), kHeight = fixed(-0.05), kSize = fixed(0.27);
  const auto angle = static_cast<Angle>(static_cast<std::uint64_t>(frame % frames) * kFullTurn / frames);
  const Fixed cosine_here = cosine(angle) >> 14, sine_here = sine(angle) >> 14;  // 2.30 -> 16.16
  const Fixed c = fixed_multiply(cosine_here, kSize), s = fixed_multiply(sine_here, kSize);
  return {.mesh = kShowroomTeapotMesh,
          .material = kShowroomTeapotMaterial,
          .transform = {{{c, 0, s, fixed_multiply(cosine_here, kRadius)},
                         {0, kSize, 0, kHeight},
                         {-s, 0, c, fixed_multiply(-sine_here, kRadius)}}}};
}

}  // namespace zstrip::scenes
