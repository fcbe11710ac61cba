// Inverts the normals of subtracted operands; only renderers with effect::csg link it.
#include "zstrip/effects/csg/operands.hpp"
#include "zstrip/effects/environment/kept.hpp"
#include "zstrip/effects/local_light/kept.hpp"

namespace zstrip::detail::csg {

void turn_normals(const FrameState& frame, std::uint32_t instance) {
  const auto turn = [](std::int16_t& component) { component = static_cast<std::int16_t>(-component); };
  const EffectBlock block = effect_block(frame);
  for (ObjectLight& light : frame.instances[instance].lights) {
    turn(light.x), turn(light.y), turn(light.z);
  }
  const auto turn_rows = [&turn](auto& rows) {
    for (auto& row : rows) {
      for (std::int16_t& component : row) turn(component);
    }
  };
  if (block.has(effect::local_light)) turn_rows(local_light::shading_of(frame, instance).normal);
  if (block.has(effect::environment)) turn_rows(environment::eye_forms_of(frame, instance).normal);
}

}  // namespace zstrip::detail::csg
