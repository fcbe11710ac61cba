// The axis of a model that points upwards, by its format.
#include "import/assimp/up_axis.hpp"

#include <assimp/metadata.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "import/ending.hpp"

namespace zstrip::sim {
namespace {

/// Formats of printing, of Blender, trueSpace, Quick3D, Half-Life and 3D GameStudio.
constexpr std::string_view kUpwardsZ[] = {".amf", ".blend", ".cob", ".scn", ".q3o", ".q3s", ".smd", ".vta", ".hmp"};

}  // namespace

UpAxis up_of_format(const aiScene& scene, const std::filesystem::path& path) {
  // Each FBX file has its own axis.
  std::int32_t axis = 0;
  if (scene.mMetaData != nullptr && scene.mMetaData->Get("UpAxis", axis)) {
    std::int32_t sign = 1;
    scene.mMetaData->Get("UpAxisSign", sign);
    constexpr UpAxis kAxes[3][2] = {
        {UpAxis::plus_x, UpAxis::minus_x}, {UpAxis::plus_y, UpAxis::minus_y}, {UpAxis::plus_z, UpAxis::minus_z}};
    if (axis >= 0 && axis < 3) return kAxes[axis][sign < 0 ? 1 : 0];
  }
  return std::ranges::find(kUpwardsZ, ending_of(path)) != std::end(kUpwardsZ) ? UpAxis::plus_z : UpAxis::plus_y;
}

}  // namespace zstrip::sim
