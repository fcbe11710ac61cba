// Declared, not there: what code without highlights, punctual lights and emission may know of them.
#pragma once

#include <cstdint>

#include "zstrip/camera.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/geometry/light.hpp"

namespace zstrip::detail {

struct FrameLights {
  std::uint32_t count;
};
struct InstanceShading {};
FrameLights frame_lights(const Scene& scene, const Camera& camera);
InstanceShading instance_shading(const Mesh& mesh, const Transform& transform, const Camera& camera);
template <Effects effects>
Colour locally_lit_colour(const CompiledInstance& instance, const Mesh& mesh, std::uint32_t vertex, const Scene& scene,
                          const FrameLights* frame, const InstanceShading* shading, const Finish& finish);

}  // namespace zstrip::detail
