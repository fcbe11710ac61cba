// Hard case D50: depth sub-ranges without a clear between frames. Rectangles move, leave and come back; views, strips,
// scenes and plans change in one and the same arena.
#include <gtest/gtest.h>

#include <random>

#include "depth_picture.hpp"

namespace hard_cases {
namespace {

using namespace zstrip;
using picture::DepthPicture;
using picture::DepthRenderer;
using picture::Model;

/// Some models with any number of vertices, so that the z-buffer lies at different places of the arena.
struct Models {
  std::vector<Model> models;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Instance> instances;

  std::mt19937 random;

  int between(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

  explicit Models(unsigned seed) : random(seed) {
    for (unsigned i = 0; i < 4; ++i) {
      models.push_back(picture::random_model(seed + i, 3 + static_cast<int>(i) * 5, 6000));
      models.back().texels.clear();
    }
    for (Model& model : models) {
      static_cast<void>(model.scene());
      meshes.push_back(model.mesh);
      materials.push_back(model.material);
    }
  }
  /// One to three of them, anywhere around the picture.
  Scene next() {
    instances.clear();
    const int count = between(1, 3);
    for (int i = 0; i < count; ++i) {
      const auto index = static_cast<std::uint16_t>(between(0, 3));
      Instance instance{.mesh = index, .material = index};
      for (auto& row : instance.transform.m) row[3] = between(-3 * kFixedOne, 3 * kFixedOne);
      instances.push_back(instance);
    }
    Scene scene;
    scene.meshes = meshes;
    scene.materials = materials;
    scene.instances = instances;
    scene.background = {255, 255, 255, 255};  // the nearest of all codes, where a picture's colours were
    return scene;
  }
};

constexpr View kViews[] = {{64, 48}, {31, 57}, {80, 20, PixelFormat::gray4}};

constexpr Effects kEffects = without(effect::all, effect::orthographic) | effect::depth_ranges;

/// Nothing of the frames before shows in the next one.
void expect_like_cleared(DepthRenderer& kept, Effects effects, const View& view, int rows, const Scene& scene,
                         const Camera& camera, int times) {
  const DepthPicture without_clear = kept.draw(scene, camera, times);
  const DepthPicture cleared = DepthRenderer(effects, view, static_cast<std::uint16_t>(rows), 0xFF).draw(scene, camera);
  ASSERT_TRUE(without_clear.status) << message(without_clear.status.error);
  ASSERT_EQ(without_clear.pixels, cleared.pixels);
  ASSERT_EQ(without_clear.depth, cleared.depth);
}

TEST(HardCases, D50_SubRangesDrawWhatAClearedBufferDoesOver1000Frames) {
  for (const Effects projection : {Effects{}, effect::orthographic}) {
    Camera camera;
    if (projection == effect::orthographic) camera.projection = Projection::orthographic;
    Models models(50);
    DepthRenderer kept(kEffects | projection, kViews[0], kViews[0].height);
    for (int frame = 0; frame < 1000; ++frame) {
      expect_like_cleared(kept, kEffects | projection, kViews[0], kViews[0].height, models.next(), camera, 1);
      if (HasFatalFailure()) FAIL() << "frame " << frame;
    }
  }
}

TEST(HardCases, D50_SubRangesOutliveChangesOfViewStripsPlanSceneAndFailures) {
  Models models(51);
  DepthRenderer kept(kEffects, kViews[0], kViews[0].height);
  for (int frame = 0; frame < 2000; ++frame) {
    const View view = kViews[models.between(0, 2)];
    const int rows = models.between(0, 1) == 0 ? view.height : models.between(1, view.height);
    const Scene scene = models.next();
    kept.set_view(view, static_cast<std::uint16_t>(rows));
    if (models.between(0, 5) == 0) {
      Camera wrong;
      wrong.near_plane = 0;
      ASSERT_EQ(kept.draw(scene, wrong).status.error, Error::camera);
    }
    expect_like_cleared(kept, kEffects, view, rows, scene, Camera{}, models.between(1, 3));
    if (HasFatalFailure()) FAIL() << "frame " << frame;
  }
}

TEST(HardCases, D50_ColoursOfAnotherPlanBehindItsSmallerZBufferAreNoDepth) {
  Models models(52);
  for (int i = 0; i < 100; ++i) {
    const Scene scene = models.next();
    DepthRenderer kept(kEffects, kViews[0], kViews[0].height);
    const View grey{64, 20, PixelFormat::gray4};
    for (const auto& [view, rows] : {std::pair{kViews[0], 48}, std::pair{grey, 20}, std::pair{kViews[0], 48}}) {
      kept.set_view(view, static_cast<std::uint16_t>(rows));
      expect_like_cleared(kept, kEffects, view, rows, scene, Camera{}, 1);
      if (HasFatalFailure()) FAIL() << "scene " << i;
    }
  }
}

}  // namespace
}  // namespace hard_cases
