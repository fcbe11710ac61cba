// Converts Assimp's lights to those of the source model.
#include "import/assimp/lights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "text/number.hpp"

namespace zstrip::sim {
namespace {

aiMatrix4x4 to_world(const aiNode* node) {
  aiMatrix4x4 transform;
  for (; node != nullptr; node = node->mParent) transform = node->mTransformation * transform;
  return transform;
}

}  // namespace

void read_lights(const aiScene& scene, const aiMatrix4x4& turn, SourceModel& model) {
  std::size_t others = 0;
  for (const aiLight* light : std::span(scene.mLights, scene.mNumLights)) {
    if (light->mType != aiLightSource_DIRECTIONAL) {
      ++others;
      continue;
    }
    const aiMatrix3x3 linear(turn * to_world(scene.mRootNode->FindNode(light->mName)));
    const aiVector3D against = -(linear * light->mDirection);
    const float length = against.Length();
    const aiColor3D& colour = light->mColorDiffuse;
    const auto usable = [](float channel) { return std::isfinite(channel) && channel >= 0; };
    if (!usable(colour.r) || !usable(colour.g) || !usable(colour.b) || std::max({colour.r, colour.g, colour.b}) == 0)
      continue;
    if (!std::isfinite(length) || !(length > 1e-20F)) continue;
    const aiVector3D towards = against / length;
    model.lights.push_back({.towards = {towards.x, towards.y, towards.z}, .colour = {colour.r, colour.g, colour.b}});
  }
  if (others > 0) {
    model.warnings.push_back(
        fmt::format("{} left out: only directional lights of this format are drawn", counted(others, "light")));
  }
}

}  // namespace zstrip::sim
