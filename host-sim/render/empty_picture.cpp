// Finds out why pictures show nothing of their scene.
#include "render/empty_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "import/quantise.hpp"
#include "render/model_animation.hpp"
#include "render/render_frame.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

std::uint32_t highest_alpha(const Texture& texture) {
  if (texture.format != TextureFormat::rgb565_alpha) return 255;
  const std::size_t texels = std::size_t{1} << (texture.log2_width + texture.log2_height);
  unsigned highest = 0;
  for (const unsigned pair : texture.texels.subspan(texels, (texels + 1) / 2)) {
    highest = std::max({highest, pair & 0xFFU, pair >> 8});
  }
  return highest;
}

/// Returns the property that hides a whole material; null if the material is visible.
const char* what_hides(const Scene& scene, const Material& material) {
  if (material.finish >= scene.finishes.size()) return nullptr;
  const Finish& finish = scene.finishes[material.finish];
  const std::uint32_t of_texture =
      material.texture < scene.textures.size() ? highest_alpha(scene.textures[material.texture]) : 255;
  const std::uint32_t alpha = (material.colour.a * of_texture + 127) / 255;
  if (finish.alpha_mode == AlphaMode::blend && alpha == 0) return "is 0";
  return finish.alpha_mode == AlphaMode::mask && alpha < finish.alpha_cutoff ? "is below its cutoff" : nullptr;
}

/// Projects points of the world to the picture, in pixels.
class Projector {
 public:
  Projector(const Camera& camera, const View& view) : camera_(camera), view_(view) {}

  /// True if the points lie in the picture, between near and far plane, within less than a pixel.
  bool is_below_a_pixel(const Affine& to_world, std::span<const Vector> points) const {
    if (points.empty()) return false;
    Vector low = project(to_world * points[0]), high = low;  // pixels, and the depth
    for (const Vector& point : points.subspan(1)) {
      const Vector at = project(to_world * point);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], at[axis]);
        high[axis] = std::max(high[axis], at[axis]);
      }
    }
    return low[2] >= from_fixed(camera_.near_plane) && high[2] <= from_fixed(camera_.far_plane) &&
           high[0] - low[0] < 1 && high[1] - low[1] < 1 && low[0] >= 0 && high[0] <= view_.width && low[1] >= 0 &&
           high[1] <= view_.height;
  }

 private:
  Vector project(const Vector& point) const {
    const auto along = [&](const Vec3& axis) {
      constexpr double kAxisOne = 1 << 30;  // 2.30
      return ((point[0] - from_fixed(camera_.eye.x)) * axis.x + (point[1] - from_fixed(camera_.eye.y)) * axis.y +
              (point[2] - from_fixed(camera_.eye.z)) * axis.z) /
             kAxisOne;
    };
    const double depth = -along(camera_.back);
    const double scale =
        from_fixed(camera_.focal) * view_.height / 2 / (camera_.projection == Projection::perspective ? depth : 1);
    return {view_.width / 2.0 + along(camera_.right) * scale, view_.height / 2.0 - along(camera_.up) * scale, depth};
  }

  const Camera& camera_;
  const View& view_;
};

}  // namespace

bool is_background(Stage& stage, const View& view, std::uint32_t crc32) {
  Result<Staging> staging = stage.place(0, 1);
  if (!staging) return false;
  Scene& scene = staging->scene;
  scene.instances = {};
  scene.quadrics = {};
  scene.lines = {};
  scene.csg = {};
  scene.edges = {};
  scene.shadow = nullptr;
  staging->tree = {};
  const Result<FrameReport> empty = FrameRenderer(view, Budget{}).render(*staging);
  return empty && empty->crc32 == crc32;
}

std::string why_unseen(Stage& stage) {
  std::string colours = "all that is drawn has the colour of the background";
  const Result<Staging> staging = stage.place(0, 1);
  if (!staging || !staging->scene.lines.empty()) return colours;
  const Scene& scene = staging->scene;
  std::set<std::uint16_t> materials;
  for (const Instance& instance : scene.instances) materials.insert(instance.material);
  for (const Quadric& quadric : scene.quadrics) materials.insert(quadric.material);
  const char* hidden = nullptr;
  for (const std::uint16_t material : materials) {
    hidden = what_hides(scene, scene.materials[material]);
    if (hidden == nullptr) return colours;
  }
  if (hidden == nullptr) return colours;
  if (materials.size() > 1) return fmt::format("the alpha of all {} materials hides them", materials.size());
  const std::vector<std::string> names = stage.origins().material_names;
  const std::uint16_t only = *materials.begin();
  const std::string name = only < names.size() ? names[only] : "";
  return fmt::format("the alpha of {} {}", name.empty() ? "its material" : fmt::format("material '{}'", name), hidden);
}

bool is_below_a_pixel(Stage& stage, const View& view) {
  const Result<Staging> staging = stage.place(0, 1);
  if (!staging) return false;
  const Scene& scene = staging->scene;
  const Projector projector(staging->camera, view);
  const auto instance_is = [&](const Instance& instance) {
    return projector.is_below_a_pixel(to_affine(instance.transform), corners_of(scene.meshes[instance.mesh]));
  };
  const auto quadric_is = [&](const Quadric& quadric) {
    return projector.is_below_a_pixel(to_affine(quadric.transform), corners_of_box({-1, -1, -1}, {1, 1, 1}));
  };
  return std::ranges::any_of(scene.instances, instance_is) || std::ranges::any_of(scene.quadrics, quadric_is);
}

std::string why_too_small(const Stage& stage, const View& view) {
  const Model* const model = stage.model();
  if (model == nullptr || model->outlying < std::max(view.width, view.height)) return {};
  const std::string times =
      model->outlying < 1e12 ? grouped(static_cast<std::uint64_t>(model->outlying)) : std::string("a trillion or more");
  return fmt::format("the model is {} times as long as the part where most of it lies; take out the parts far away",
                     times);
}

}  // namespace zstrip::sim
