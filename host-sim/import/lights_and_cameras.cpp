// Lights and cameras of a file's scene: Assimp's as those of the source model.
#include "import/lights_and_cameras.hpp"

#include <assimp/version.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "report/number.hpp"

namespace zstrip::sim {
namespace {

bool finite(const aiVector3D& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Unit length, or zero where there is no direction.
aiVector3D direction(const aiVector3D& v) {
  const float length = v.Length();
  return std::isfinite(length) && length > 1e-20F ? v / length : aiVector3D();
}

aiMatrix4x4 to_world(const aiNode* node) {
  aiMatrix4x4 transform;
  for (; node != nullptr; node = node->mParent) transform = node->mTransformation * transform;
  return transform;
}

std::optional<SourceLightType> type_of(const aiLight& light, bool gltf) {
  if (light.mType == aiLightSource_DIRECTIONAL) return SourceLightType::directional;
  if (gltf && light.mType == aiLightSource_POINT) return SourceLightType::point;
  if (gltf && light.mType == aiLightSource_SPOT) return SourceLightType::spot;
  return std::nullopt;
}

/// Assimp keeps a light's range with its node; 0: it has none.
double range_of(const aiNode* node) {
  float range = 0;
  if (node == nullptr || node->mMetaData == nullptr || !node->mMetaData->Get("PBR_LightRange", range)) return 0;
  return std::isfinite(range) && range > 0 ? double{range} : 0;
}

/// glTF's vertical field of view, in radians, from the horizontal one that Assimp makes of it: times the aspect before
/// 5.3 (assimp/assimp#4886), by the tangent since.
double vertical_field_of_view(const aiCamera& camera, double aspect) {
  if (aiGetVersionMajor() == 5 && aiGetVersionMinor() < 3) return camera.mHorizontalFOV / aspect;
  return 2 * std::atan(std::tan(camera.mHorizontalFOV / 2) / aspect);
}

}  // namespace

void read_lights(const aiScene& scene, const aiMatrix4x4& turn, bool gltf, SourceModel& model) {
  std::size_t others = 0;
  for (const aiLight* light : std::span(scene.mLights, scene.mNumLights)) {
    const std::optional<SourceLightType> type = type_of(*light, gltf);
    if (!type) {
      ++others;
      continue;
    }
    const aiNode* const node = scene.mRootNode->FindNode(light->mName);
    const aiMatrix4x4 transform = turn * to_world(node);
    const aiVector3D towards = direction(-(aiMatrix3x3(transform) * light->mDirection));
    const aiVector3D position = transform * aiVector3D();
    const aiColor3D& colour = light->mColorDiffuse;
    const auto usable = [](float channel) { return std::isfinite(channel) && channel >= 0; };
    if (!usable(colour.r) || !usable(colour.g) || !usable(colour.b) || std::max({colour.r, colour.g, colour.b}) == 0)
      continue;
    if (*type != SourceLightType::point && towards.SquareLength() == 0) continue;
    if (*type != SourceLightType::directional && !finite(position)) continue;
    SourceLight read{.type = *type,
                     .towards = {towards.x, towards.y, towards.z},
                     .colour = {colour.r, colour.g, colour.b},
                     .position = {position.x, position.y, position.z},
                     .range = range_of(node)};
    if (*type == SourceLightType::spot) {
      constexpr float kWidest = std::numbers::pi_v<float> / 2;
      read.outer = light->mAngleOuterCone >= 0 ? std::min(light->mAngleOuterCone, kWidest) : kWidest / 2;
      read.inner = light->mAngleInnerCone >= 0 ? std::min<double>(light->mAngleInnerCone, read.outer) : 0;
    }
    model.lights.push_back(read);
  }
  if (others > 0) {
    model.warnings.push_back(
        fmt::format("{} left out: only {} are drawn", counted(others, "light"),
                    gltf ? "directional, point and spot lights" : "directional lights of this format"));
  }
}

void read_cameras(const aiScene& scene, const aiMatrix4x4& turn, SourceModel& model) {
  for (const aiCamera* camera : std::span(scene.mCameras, scene.mNumCameras)) {
    const aiMatrix4x4 transform = turn * to_world(scene.mRootNode->FindNode(camera->mName));
    const aiMatrix3x3 linear(transform);
    // At its node's origin: Assimp 5.2 gives the node's translation a second time as the camera's position.
    const aiVector3D eye = transform * aiVector3D();
    const aiVector3D towards = direction(linear * camera->mLookAt);
    const aiVector3D up = direction(linear * camera->mUp);
    if (!finite(eye) || towards.SquareLength() == 0) continue;
    SourceCamera read{.name = camera->mName.C_Str(),
                      .eye = {eye.x, eye.y, eye.z},
                      .towards = {towards.x, towards.y, towards.z},
                      .up = {up.x, up.y, up.z}};
    read.orthographic = camera->mOrthographicWidth > 0;
    const double aspect = camera->mAspect > 0 ? camera->mAspect : 1;
    if (read.orthographic) {
      read.half_height = camera->mOrthographicWidth / aspect;  // glTF's xmag is half of the width
    } else {
      read.field_of_view = vertical_field_of_view(*camera, aspect) * 180 / std::numbers::pi;
    }
    model.cameras.push_back(read);
  }
}

}  // namespace zstrip::sim
