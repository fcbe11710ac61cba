// Declared, not there: what code without environment maps may know of them.
#pragma once

#include "zstrip/camera.hpp"
#include "zstrip/effects/environment/effect.hpp"
#include "zstrip/geometry/instance.hpp"

namespace zstrip::detail {

struct EyeForms {
  alignas(4) char unused[environment::Effect::kEyeFormsBytes];
};
struct MirroredPoint {};
EyeForms eye_forms(const Mesh& mesh, const Transform& transform, const Camera& camera);
template <bool orthographic>
MirroredPoint mirrored_point(const EyeForms& forms, const Position& position, const Normal& normal, bool double_sided);
TexCoord texcoord_of(const MirroredPoint& point, std::uint8_t log2_width, std::uint8_t log2_height);

}  // namespace zstrip::detail
