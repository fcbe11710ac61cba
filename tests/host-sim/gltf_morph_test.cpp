// Morph targets of glTF 2.0 files made to measure: where each corner and its normal are at each frame, summed in
// double.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "gltf_file.hpp"
#include "import/quantise.hpp"
#include "render/stage.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

using Place = std::array<double, 3>;

constexpr std::size_t kCorners = 5;
constexpr double kSeconds = 2;

/// A pyramid over a square, with two targets: one lifts and turns the tip, one widens two corners of the base. The node
/// is turned about x, scaled and moved.
struct Pyramid {
  std::string interpolation = "LINEAR";
  std::vector<float> times{0, 0.5F, 2}, values{0, 0, 1, 0.25F, 0.5F, 1};  ///< two weights a key
  std::vector<double> rest{0, 0};                                         ///< of the node
  bool sparse = false;                                                    ///< the first target
  bool double_sided = false;                                              ///< and without its base
  bool normals = true;
  bool widens = true;  ///< else the second target moves nothing

  static constexpr std::array<Place, kCorners> kPlaces{
      {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0.25, 1.5, 0}}};
  static constexpr std::array<Place, kCorners> kNormals{{{0, -1, 0}, {0, -1, 0}, {0, -1, 0}, {0, -1, 0}, {0, 1, 0}}};
  static constexpr std::array<Place, kCorners> kLift{{{}, {}, {}, {}, {0.5, 1, -0.25}}};
  static constexpr std::array<Place, kCorners> kTurn{{{}, {}, {}, {}, {1, -1, 0.5}}};
  static constexpr std::array<Place, kCorners> kWide{{{}, {0.5, 0, -0.5}, {0.25, 0.125, 0.5}, {}, {}}};

  std::string gltf() const;
};

std::vector<float> flat(const std::array<Place, kCorners>& places) {
  std::vector<float> all;
  for (const Place& place : places) {
    for (const double c : place) all.push_back(static_cast<float>(c));
  }
  return all;
}

std::string text_of(std::size_t value) { return std::to_string(value); }

std::string Pyramid::gltf() const {
  GltfData data;
  const std::size_t places = data.add_floats(flat(kPlaces), "VEC3"), at = data.add_floats(flat(kNormals), "VEC3");
  std::vector<std::uint16_t> faces{1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4};
  if (!double_sided) faces.insert(faces.end(), {0, 1, 2, 0, 2, 3});
  const std::size_t indices = data.add_indices(faces);
  std::size_t lift = 0;
  if (sparse) {
    const std::size_t tip = data.add(std::string("\4\0\0\0", 4), R"("componentType":5123,"count":1,"type":"SCALAR")");
    const std::size_t offset = data.add_floats({0.5F, 1, -0.25F}, "VEC3");
    lift = data.add(floats({0}), R"("componentType":5126,"count":1,"type":"SCALAR"},{"componentType":5126,"count":5,)"
                                 R"("type":"VEC3","sparse":{"count":1,"indices":{"bufferView":)" +
                                     text_of(tip) + R"(,"componentType":5123},"values":{"bufferView":)" +
                                     text_of(offset) + "}}") +
           1;
  } else {
    lift = data.add_floats(flat(kLift), "VEC3");
  }
  // The sparse accessor has no view of its own: the ones after it count one more.
  const std::size_t more = sparse ? 1 : 0;
  const std::size_t turn = data.add_floats(flat(kTurn), "VEC3") + more;
  const std::size_t wide = data.add_floats(flat(widens ? kWide : std::array<Place, kCorners>{}), "VEC3") + more;
  const std::size_t input = data.add_floats(times, "SCALAR") + more;
  const std::size_t output = data.add_floats(values, "SCALAR") + more;
  const std::string normal = normals ? R"(,"NORMAL":)" : "";
  return gltf_of(
      R"("nodes":[{"mesh":0,"translation":[3,4,5],"rotation":[0.6,0,0,0.8],"scale":[2,2,2],"weights":[)" +
      std::to_string(rest[0]) + "," + std::to_string(rest[1]) + R"(]}],"materials":[{"doubleSided":)" +
      (double_sided ? "true" : "false") + R"(}],"meshes":[{"primitives":[{"material":0,"attributes":{"POSITION":)" +
      text_of(places) + (normals ? normal + text_of(at) : "") + R"(},"indices":)" + text_of(indices) +
      R"(,"targets":[{"POSITION":)" + text_of(lift) + (normals ? normal + text_of(turn) : "") + R"(},{"POSITION":)" +
      text_of(wide) +
      R"(}]}]}],"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],"samplers":[{)"
      R"("interpolation":")" +
      interpolation + R"(","input":)" + text_of(input) + R"(,"output":)" + text_of(output) + "}]}]," + data.json());
}

/// Through the node: turned about x by twice the angle whose half has sine 0.6 and cosine 0.8.
Place turned(const Place& p) { return {p[0], 0.28 * p[1] - 0.96 * p[2], 0.96 * p[1] + 0.28 * p[2]}; }

Place placed(const Place& p) {
  const Place t = turned(p);
  return {2 * t[0] + 3, 2 * t[1] + 4, 2 * t[2] + 5};
}

struct Corner {
  Place place{}, normal{};
};

std::vector<Corner> expected(const std::array<double, 2>& weights) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < kCorners; ++i) {
    Place place{}, normal{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      place[axis] =
          Pyramid::kPlaces[i][axis] + weights[0] * Pyramid::kLift[i][axis] + weights[1] * Pyramid::kWide[i][axis];
      normal[axis] = Pyramid::kNormals[i][axis] + weights[0] * Pyramid::kTurn[i][axis];
    }
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (double& c : normal) c /= length;
    corners.push_back({placed(place), turned(normal)});
  }
  return corners;
}

class GltfMorph : public FolderTest {
 protected:
  Result<std::unique_ptr<Stage>> open(const std::string& gltf) const {
    return open_stage(file("pyramid.gltf", gltf), {}, {}, {320, 240}, 8);
  }
  std::unique_ptr<Stage> opened(const Pyramid& pyramid) const {
    Result<std::unique_ptr<Stage>> stage = open(pyramid.gltf());
    EXPECT_TRUE(stage) << stage.failure().message;
    return stage ? std::move(*stage) : nullptr;
  }

  static std::vector<Corner> corners(Stage& stage, const Scene& scene) {
    const Units& units = stage.model()->units;
    std::vector<Corner> all;
    for (const Instance& instance : scene.instances) {
      const Mesh& mesh = scene.meshes[instance.mesh];
      for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const std::array<Fixed, 3> centre{mesh.centre.x, mesh.centre.y, mesh.centre.z},
            half{mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z};
        const std::array<std::int16_t, 3> steps{mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z};
        const std::array<std::int8_t, 3> normal{mesh.normals[i].x, mesh.normals[i].y, mesh.normals[i].z};
        Corner& to = all.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double scene_units = from_fixed(centre[axis]) + from_fixed(half[axis]) * steps[axis] / 32768;
          to.place[axis] = scene_units / units.scale + units.origin[axis];
          to.normal[axis] = normal[axis] / 127.0;
        }
      }
    }
    return all;
  }

  static double apart(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

  /// Every corner has a vertex, and every vertex a corner. `backs`: with a reversed copy of each.
  static void expect(Stage& stage, const Scene& scene, const std::array<double, 2>& weights, const std::string& what,
                     bool backs = false) {
    std::vector<Corner> wanted = expected(weights);
    for (std::size_t i = 0; backs && i < kCorners; ++i) {
      Corner back = wanted[i];
      for (double& c : back.normal) c = -c;
      wanted.push_back(back);
    }
    const std::vector<Corner> found = corners(stage, scene);
    EXPECT_EQ(found.size(), wanted.size()) << what;
    // A tenth of a pixel where 4 units fill 320 pixels; a normal has 7 bits, and its offsets have 6.
    constexpr double kPlaceTolerance = 0.003, kNormalTolerance = 0.03;
    const auto matched = [&](const std::vector<Corner>& from, const std::vector<Corner>& to) {
      return std::ranges::all_of(from, [&](const Corner& a) {
        return std::ranges::any_of(to, [&](const Corner& b) {
          return apart(a.place, b.place) < kPlaceTolerance && apart(a.normal, b.normal) < kNormalTolerance;
        });
      });
    };
    EXPECT_TRUE(matched(wanted, found)) << what;
    EXPECT_TRUE(matched(found, wanted)) << what;
  }
};

/// Between two keys.
double mixed(double from, double to, double share) { return from + (to - from) * share; }

TEST_F(GltfMorph, CornersAndNormalsAreWhereWeightsMoveThem) {
  for (const bool sparse : {false, true}) {
    for (const bool double_sided : {false, true}) {
      const auto stage = opened({.sparse = sparse, .double_sided = double_sided});
      ASSERT_TRUE(stage);
      EXPECT_TRUE(stage->warnings().empty()) << stage->warnings()[0];
      EXPECT_TRUE(stage->bends());
      for (std::uint32_t frame = 0; frame < 8; ++frame) {
        const Result<Staging> staging = stage->place(frame, 8);
        ASSERT_TRUE(staging) << staging.failure().message;
        const double seconds = frame * kSeconds / 8, second = (seconds - 0.5) / 1.5;
        const std::array<double, 2> weights =
            seconds < 0.5 ? std::array{mixed(0, 1, seconds / 0.5), mixed(0, 0.25, seconds / 0.5)}
                          : std::array{mixed(1, 0.5, second), mixed(0.25, 1, second)};
        expect(*stage, staging->scene, weights, "frame " + std::to_string(frame), double_sided);
      }
    }
  }
}

TEST_F(GltfMorph, StepsAndSplinesAreThoseOfGltf) {
  const auto step = opened({.interpolation = "STEP"});
  ASSERT_TRUE(step);
  for (const std::uint32_t frame : {0U, 1U, 2U, 7U}) {
    const Result<Staging> staging = step->place(frame, 8);
    ASSERT_TRUE(staging) << staging.failure().message;
    expect(*step, staging->scene, frame < 2 ? std::array{0.0, 0.0} : std::array{1.0, 0.25}, std::to_string(frame));
  }
  // Slopes in, values, slopes out, two weights each. At the middle of two seconds: the mean of the values and an eighth
  // of the duration times the difference of the slopes.
  const auto spline =
      opened({.interpolation = "CUBICSPLINE", .times = {0, 2}, .values = {9, 9, 0, 0, 1, 0, 0, -1, 1, 0.5F, 9, 9}});
  ASSERT_TRUE(spline);
  const Result<Staging> staging = spline->place(4, 8);
  ASSERT_TRUE(staging) << staging.failure().message;
  expect(*spline, staging->scene, {0.5 + 0.25 * (1 - 0), 0.25 + 0.25 * (0 + 1)}, "the middle of a spline");
}

/// Vertices are stored at rest: weights count from there.
TEST_F(GltfMorph, WeightsAtRestAreTheFirstShape) {
  const auto stage = opened({.rest = {0.5, -0.25}});
  ASSERT_TRUE(stage);
  for (const Mesh& mesh : stage->model()->meshes) EXPECT_EQ(mesh.positions.size(), kCorners);
  const Scene at_rest{.meshes = stage->model()->meshes,
                      .materials = {},
                      .textures = {},
                      .instances = stage->model()->instances,
                      .lights = {}};
  expect(*stage, at_rest, {0.5, -0.25}, "at rest");
  const Result<Staging> staging = stage->place(2, 8);
  ASSERT_TRUE(staging);
  expect(*stage, staging->scene, {1, 0.25}, "half a second after the start");
}

TEST_F(GltfMorph, OnlyVerticesThatATargetMovesAreInItsRuns) {
  const auto stage = opened({});
  ASSERT_TRUE(stage);
  const Model& model = *stage->model();
  ASSERT_EQ(model.weights.size(), 2U);
  ASSERT_EQ(model.morphs.size(), 1U);
  const std::vector<MorphTarget>& targets = model.morphs[0].targets;
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[0].positions.size(), 1U);
  EXPECT_EQ(targets[0].normals.size(), 1U);
  EXPECT_EQ(targets[1].positions.size(), 2U);
  EXPECT_TRUE(targets[1].normals.empty()) << "no normal moves";
  const auto still = opened({.values = {0, 0, 1, 0, 0.5F, 0}});
  ASSERT_TRUE(still);
  ASSERT_EQ(still->model()->weights.size(), 1U) << "the second weight never changes";
}

/// Their weights were beyond the renderer's range.
TEST_F(GltfMorph, LargeWeightsAreDrawn) {
  const auto stage = opened({.values = {0, 0, 0, 0.25F, 0, 40}});
  ASSERT_TRUE(stage);
  const Result<Staging> staging = stage->place(7, 8);
  ASSERT_TRUE(staging) << staging.failure().message;
  const double weight = mixed(0.25, 40, (1.75 - 0.5) / 1.5);
  const std::vector<Corner> found = corners(*stage, staging->scene), wanted = expected({0, weight});
  for (const Corner& corner : wanted) {
    double least = 1e9;
    for (const Corner& other : found) least = std::min(least, apart(corner.place, other.place));
    EXPECT_LT(least, 0.05) << "of a box of some 60 units";
  }
}

TEST_F(GltfMorph, ATargetThatMovesNothingHadAWeightThatBlobsRefuse) {
  const auto stage = opened({.widens = false});
  ASSERT_TRUE(stage);
  ASSERT_EQ(stage->weight_animation().tracks.size(), 1U);
  EXPECT_EQ(stage->weight_animation().tracks[0].instance, 0U);
}

TEST_F(GltfMorph, DamageIsSaid) {
  const auto short_of_values = open(Pyramid{.values = {0, 0, 1, 0.25F, 0.5F}}.gltf());
  ASSERT_FALSE(short_of_values);
  EXPECT_NE(short_of_values.failure().message.find("a sampler of an animation has too few values"), std::string::npos);
  const float nan = std::nanf("");
  const auto stage = opened({.values = {0, 0, nan, 0.25F, 0.5F, 1}});
  ASSERT_TRUE(stage);
  ASSERT_EQ(stage->warnings().size(), 1U);
  EXPECT_EQ(stage->warnings()[0], "animation '': 1 key left out, no number or not later than the one before");
  std::string missing = Pyramid{}.gltf();
  const std::string target = R"("targets":[{"POSITION":3)";
  ASSERT_NE(missing.find(target), std::string::npos);
  missing.replace(missing.find(target), target.size(), R"("targets":[{"POSITION":77)");
  const auto lost = open(missing);
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.failure().status, ExitStatus::input);
}

/// A triangle that morphs along y while its joint moves along x.
TEST_F(GltfMorph, ASkinMovesTheMorphedVertices) {
  GltfData data;
  const std::size_t corners_at = data.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const std::size_t up = data.add_floats({0, 0, 0, 0, 0, 0, 0, 2, 0}, "VEC3");
  const std::size_t joints = data.add(std::string(12, '\0'), R"("componentType":5121,"count":3,"type":"VEC4")");
  const std::size_t weights = data.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  const std::size_t indices = data.add_indices({0, 1, 2});
  const std::size_t times = data.add_floats({0, 2}, "SCALAR");
  const std::size_t places = data.add_floats({0, 0, 0, 8, 0, 0}, "VEC3");
  const std::size_t shares = data.add_floats({0, 1}, "SCALAR");
  const std::string text =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"skin":0},{}],)"
      R"("skins":[{"joints":[1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":)" +
      text_of(corners_at) + R"(,"JOINTS_0":)" + text_of(joints) + R"(,"WEIGHTS_0":)" + text_of(weights) +
      R"(},"targets":[{"POSITION":)" + text_of(up) + R"(}],"indices":)" + text_of(indices) +
      R"(}]}],"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"translation"}},)"
      R"({"sampler":1,"target":{"node":0,"path":"weights"}}],"samplers":[{"input":)" +
      text_of(times) + R"(,"output":)" + text_of(places) + R"(},{"input":)" + text_of(times) + R"(,"output":)" +
      text_of(shares) + "}]}]," + data.json() + "}";
  const Result<std::unique_ptr<Stage>> stage = open(text);
  ASSERT_TRUE(stage) << stage.failure().message;
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    const Result<Staging> staging = (*stage)->place(frame, 8);
    ASSERT_TRUE(staging) << staging.failure().message;
    const double share = frame / 8.0;
    const std::vector<Corner> found = corners(**stage, staging->scene);
    for (const Place& wanted :
         {Place{8 * share, 0, 0}, Place{1 + 8 * share, 0, 0}, Place{8 * share, 1 + 2 * share, 0}}) {
      double least = 1e9;
      for (const Corner& corner : found) least = std::min(least, apart(corner.place, wanted));
      EXPECT_LT(least, 0.01) << frame;
    }
  }
}

}  // namespace
}  // namespace zstrip::sim::test
