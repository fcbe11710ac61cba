// Stages the built-in scenes, and the bunny as if it were one.
#include "measured_scenes.hpp"

#include <cstdint>

#include "import/model.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace store_test {
namespace {

using namespace zstrip;

constexpr View kView{320, 240};
constexpr std::uint32_t kFrames = 6;

Image draw(const Scene& scene, const Camera& camera, Content content) {
  switch (content) {
    case Content::small_float: return draw_small_float(scene, camera, kView);
    case Content::fitted: return draw_fitted(scene, camera, kView);
    default: return draw_colour(scene, camera, kView);
  }
}

std::vector<Image> draw(const scenes::BuiltIn& built_in, Content content) {
  std::vector<Image> images;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    scenes::Staged staged;
    if (built_in.turns == scenes::Turns::camera) {
      scenes::stage(built_in, staged, frame, kFrames, kView);
    } else {
      scenes::stage_workload(built_in, staged, 10 * frame);
    }
    images.push_back(draw(staged.scene, staged.camera, content));
  }
  return images;
}

}  // namespace

std::vector<Image> images_of(const std::string& scene, Content content) {
  if (const scenes::BuiltIn* built_in = scenes::find(scene)) return draw(*built_in, content);
  if (scene != "bunny") return {};
  const sim::Result<sim::Model> model = sim::import_model(ZSTRIP_BUNNY);
  if (!model) return {};
  scenes::BuiltIn bunny{};
  bunny.scene.meshes = model->meshes;
  bunny.scene.materials = model->materials;
  bunny.scene.instances = model->instances;
  return draw(bunny, content);
}

}  // namespace store_test
