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

std::vector<DepthImage> draw(const scenes::BuiltIn& built_in, DepthFormat format) {
  std::vector<DepthImage> images;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    scenes::Staged staged;
    if (built_in.turns == scenes::Turns::camera) {
      scenes::stage(built_in, staged, frame, kFrames, kView);
    } else {
      scenes::stage_workload(built_in, staged, 10 * frame);
    }
    images.push_back(format == DepthFormat::small_float ? draw_small_float(staged.scene, staged.camera, kView)
                                                        : draw_fitted(staged.scene, staged.camera, kView));
  }
  return images;
}

}  // namespace

std::vector<DepthImage> depth_images(const std::string& scene, DepthFormat format) {
  if (const scenes::BuiltIn* built_in = scenes::find(scene)) return draw(*built_in, format);
  if (scene != "bunny") return {};
  const sim::Result<sim::Model> model = sim::import_model(ZSTRIP_BUNNY);
  if (!model) return {};
  scenes::BuiltIn bunny{};
  bunny.scene.meshes = model->meshes;
  bunny.scene.materials = model->materials;
  bunny.scene.instances = model->instances;
  return draw(bunny, format);
}

}  // namespace store_test
