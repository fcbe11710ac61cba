// Scenes and models, drawn by the renderer and by OpenGL, frame by frame: Reference.<scene>_<frame>.
// A failure leaves both pictures and their difference in the build folder and says where; with the environment variable
// ZSTRIP_KEEP_PICTURES set, success does too.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "compare.hpp"
#include "evidence.hpp"
#include "reference_picture.hpp"
#include "render/stage.hpp"
#include "renderer_picture.hpp"
#include "zstrip_scenes/scenes.hpp"

namespace zstrip::reference {
namespace {

constexpr View kView{.width = 320, .height = 240};
constexpr std::uint32_t kFrames = 12;  // of a turn

/// What a comparison may find at most. Errors in units of an 8-bit channel, see Comparison. Each bound is the worst of
/// all frames here, rounded up.
struct Bounds {
  double excess;              ///< of the colour before it is truncated to RGB565
  double mean;                ///< after; the worst is one code
  double exact = 0.99;        ///< share of the drawn pixels that show what the reference shows at the very centre
  double silhouette = 0.005;  ///< share of the drawn pixels that only one picture draws
  std::uint32_t strays = 0;
  std::uint32_t slivers = 10;
  std::uint32_t foreign = 0;
};

/// Nothing is computed: flat vertex colours, texels without light. The excess is float's.
constexpr Bounds kCopied{.excess = 0.001, .mean = 0};
/// Half a unit is added for rounding at the vertices, the planes round down, snapping moves the gradient.
constexpr Bounds kGouraud{.excess = 0.5, .mean = 0.6, .exact = 0.98};
/// Cosines are truncated to 1/256, then the light times the material, then the sum is interpolated.
constexpr Bounds kLit{.excess = 1.2, .mean = 0.5};
/// Light, truncated to 1/256, multiplies texels of 5 or 6 bits and the product is truncated once more: below one code.
constexpr Bounds kLitTexture{.excess = 3.6, .mean = 1.8};

/// Pixels by which texels drift along a row, see draw_reference: of faces nearly edge-on, close to the camera. There,
/// fewer pixels show the very texel of their centre.
constexpr float kSteepDrift = 0.75F;

constexpr Bounds with_exact(Bounds bounds, double exact) {
  bounds.exact = exact;
  return bounds;
}

/// Unconnected triangles of a few pixels: needles so thin that pixels' centres meet them rarely, and then in one
/// picture only, with neither a neighbour; and pairs of edges in one pixel, which snapping moves apart so that what
/// lies behind both shows.
constexpr Bounds kTinyTriangles{
    .excess = kCopied.excess, .mean = 0, .exact = 0.96, .silhouette = 0.05, .strays = 16, .slivers = 20, .foreign = 5};
constexpr Bounds kNeedles{.excess = kCopied.excess, .mean = 0, .strays = 3};

struct Case {
  std::string name;    ///< of the test
  std::string folder;  ///< of models; empty: not installed
  std::string scene;   ///< built-in, or a file of the folder
  std::vector<std::uint32_t> frames;
  Bounds bounds;
  float drift = 0;
  bool orthographic = false;
};

class ReferenceTest : public ::testing::Test {
 public:
  ReferenceTest(Case what, std::uint32_t frame) : case_(std::move(what)), frame_(frame) {}
  void TestBody() override;

 private:
  void judge(const Comparison& result) const;

  Case case_;
  std::uint32_t frame_;
};

void ReferenceTest::judge(const Comparison& result) const {
  const Bounds& bounds = case_.bounds;
  constexpr double kOneCode = 9;  // of five bits, widened: 8 or 9
  EXPECT_EQ(result.of(Verdict::coverage), 0U);
  EXPECT_EQ(result.of(Verdict::shading), 0U) << "worst excess " << result.worst_excess;
  EXPECT_LE(result.of(Verdict::foreign), bounds.foreign);
  EXPECT_LE(result.of(Verdict::sliver), bounds.slivers);
  EXPECT_LE(result.mean_error, bounds.mean);
  EXPECT_LE(result.worst_error, bounds.mean == 0 ? 0 : kOneCode);
  EXPECT_GE(result.exact, bounds.exact * result.drawn);
  EXPECT_LE(result.silhouette_differs, bounds.silhouette * result.drawn);
  EXPECT_LE(result.silhouette_strays, bounds.strays);
  EXPECT_GT(result.drawn, kView.width * kView.height / 20U);
}

void ReferenceTest::TestBody() {
  const bool built_in = scenes::find(case_.scene) != nullptr;
  if (!built_in && case_.folder.empty()) GTEST_SKIP() << case_.scene << " is not installed";
  sim::CameraOptions camera;
  camera.orthographic = case_.orthographic;
  auto stage = sim::open_stage(built_in ? case_.scene : case_.folder + "/" + case_.scene, sim::ModelOptions{}, camera,
                               kView, kFrames);
  ASSERT_TRUE(stage) << stage.failure().message;
  const auto staging = (*stage)->place(frame_, kFrames);
  ASSERT_TRUE(staging) << staging.failure().message;
  const auto picture = draw(*staging, kView);
  ASSERT_TRUE(picture) << picture.failure().message;
  const auto reference = draw_reference(*staging, kView, case_.drift);
  ASSERT_TRUE(reference) << reference.failure().message;

  const Comparison result = compare(*picture, *reference, case_.bounds.excess);
  judge(result);
  std::cout << result;
  if (!HasFailure() && std::getenv("ZSTRIP_KEEP_PICTURES") == nullptr) return;
  const auto path = write_evidence(case_.name + "_" + std::to_string(frame_), *picture, *reference, result);
  ASSERT_TRUE(path) << path.failure().message;
  std::cout << "pictures: " << *path << ".*.png\n";
}

std::vector<Case> cases() {
  const std::string glmark2 = GLMARK2_MODELS, assimp = ASSIMP_MODELS;
  return {
      {"teapot", {}, "teapot", {0, 1, 4, 9}, kLit},
      {"teapot_orthographic", {}, "teapot", {2}, kLit, 0, true},
      {"knot", {}, "knot", {0, 1, 4, 9}, kGouraud},
      {"knot_flat", {}, "knot_flat", {0, 4}, kCopied},
      {"knot_lit", {}, "knot_lit", {0, 1, 4, 9}, kLit},
      {"knot_textured", {}, "knot_textured", {0, 4}, kLitTexture},
      {"cube", {}, "cube", {0, 1, 4, 9}, with_exact(kCopied, 0.85), kSteepDrift},
      {"cube_orthographic", {}, "cube", {1}, with_exact(kCopied, 0.97), 0, true},
      {"room", {}, "room", {0, 1, 4}, with_exact(kLitTexture, 0.98), kSteepDrift},
      // Frames 7 to 11 show lit texels nearly everywhere, 1.85 to 2.03: a mean of theirs alone, not with plain boxes.
      {"room", {}, "room", {9}, {.excess = kLitTexture.excess, .mean = 1.9, .exact = 0.98}, kSteepDrift},
      {"random50", {}, "random50", {0, 1}, kNeedles},
      {"random10k", {}, "random10k", {0, 1, 4}, kTinyTriangles},
      {"bunny", glmark2, "bunny.obj", {0, 7}, kLit},
      {"horse", glmark2, "horse.3ds", {0, 5}, kLit},
      {"cat", glmark2, "cat.3ds", {0, 5}, kLit},
      {"box_textured",
       assimp,
       "glTF2/BoxTextured-glTF/BoxTextured.gltf",
       {1, 4},
       with_exact(kLitTexture, 0.98),
       kSteepDrift},
      {"texture_transform", assimp, "glTF2/textureTransform/TextureTransformTest.gltf", {0, 1}, kLitTexture, 0.125F},
      {"milk_truck",
       assimp,
       "glTF/CesiumMilkTruck/CesiumMilkTruck.gltf",
       {1, 4},
       with_exact(kLitTexture, 0.98),
       kSteepDrift},
  };
}

bool register_all() {
  for (const Case& each : cases()) {
    for (const std::uint32_t frame : each.frames) {
      const std::string name = each.name + "_" + std::to_string(frame);
      ::testing::RegisterTest("Reference", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                              [each, frame] { return new ReferenceTest(each, frame); });
    }
  }
  return true;
}

[[maybe_unused]] const bool kRegistered = register_all();

}  // namespace
}  // namespace zstrip::reference
