// Skins of glTF 2.0 files made to measure: where each corner is at each frame, by matrices written out in double.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gltf_file.hpp"
#include "import/quantise.hpp"
#include "render/stage.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

/// An eel along x: rings of three corners, a joint for every second ring, each vertex between two of them. Its joints
/// hang below an armature that is turned and scaled, as from Blender; the node of the mesh is moved, which means
/// nothing to a skin. The animation bends each joint about its own axis.
struct Eel {
  static constexpr std::size_t kRings = 17, kJoints = 9;
  static constexpr double kSeconds = 2, kBend = 0.3, kScale = 0.01;
  bool animated = true;
  float first_weight = 1;  ///< of the first corner and its joint
  float first_bind = 1;    ///< a factor of x in the first joint's matrix

  static std::array<double, 3> corner(std::size_t ring, std::size_t side) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(side) / 3;
    const double radius = 30 + 10 * std::sin(static_cast<double>(ring));
    return {100 * static_cast<double>(ring), radius * std::cos(angle), radius * std::sin(angle)};
  }
  /// The joint before it, and how much of it the next one has: quarters.
  static std::pair<std::size_t, double> weights(std::size_t ring) {
    return {std::min(ring / 2, kJoints - 1), ring % 2 == 0 || ring / 2 + 1 >= kJoints ? 0.0 : 0.25};
  }
  /// Of a joint, `share` of the way to the second key; about z, and every third about y.
  static double angle(std::size_t joint, double share) { return share * kBend * (joint % 4 == 1 ? -1 : 1); }
  static bool about_y(std::size_t joint) { return joint % 3 == 2; }

  std::string gltf() const;
};

std::string json_of(std::size_t value) { return std::to_string(value); }

std::string Eel::gltf() const {
  std::string buffer, views, accessors;
  std::size_t count = 0;
  const auto add = [&](const std::string& bytes, const std::string& what) {
    const std::string comma = count == 0 ? "" : ",";
    views += comma + R"({"buffer":0,"byteOffset":)" + json_of(buffer.size()) + R"(,"byteLength":)" +
             json_of(bytes.size()) + "}";
    accessors += comma + R"({"bufferView":)" + json_of(count) + "," + what + "}";
    buffer += bytes;
    return count++;
  };
  std::vector<float> positions, weight_values, times{0, kSeconds};
  std::string joint_bytes, indices;
  const auto index = [&](std::size_t value) {
    indices += static_cast<char>(value & 0xFF);
    indices += static_cast<char>(value >> 8);
  };
  for (std::size_t ring = 0; ring < kRings; ++ring) {
    for (std::size_t side = 0; side < 3; ++side) {
      for (const double c : corner(ring, side)) positions.push_back(static_cast<float>(c));
      const auto [joint, share] = weights(ring);
      weight_values.insert(weight_values.end(), {static_cast<float>(1 - share), static_cast<float>(share), 0, 0});
      if (ring + side == 0) weight_values[0] = first_weight;
      joint_bytes += {static_cast<char>(joint), static_cast<char>(std::min(joint + 1, kJoints - 1)), 0, 0};
      if (ring + 1 == kRings) continue;
      const std::size_t a = 3 * ring + side, b = 3 * ring + (side + 1) % 3;
      for (const std::size_t i : {a, b, a + 3, b, b + 3, a + 3}) index(i);
    }
  }
  const std::string vertices = json_of(3 * kRings);
  add(floats(positions),
      R"("componentType":5126,"count":)" + vertices + R"(,"type":"VEC3","min":[0,-40,-40],"max":[1600,40,40])");
  add(joint_bytes, R"("componentType":5121,"count":)" + vertices + R"(,"type":"VEC4")");
  add(floats(weight_values), R"("componentType":5126,"count":)" + vertices + R"(,"type":"VEC4")");
  add(indices, R"("componentType":5123,"count":)" + json_of(indices.size() / 2) + R"(,"type":"SCALAR")");
  std::vector<float> binds;  // joint i is modelled at 200 i along x
  for (std::size_t i = 0; i < kJoints; ++i) {
    binds.insert(binds.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -200 * static_cast<float>(i), 0, 0, 1});
  }
  binds[0] = first_bind;
  add(floats(binds), R"("componentType":5126,"count":)" + json_of(kJoints) + R"(,"type":"MAT4")");
  add(floats(times), R"("componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[2])");
  std::string samplers, channels, nodes, joints;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto half = [&](double share) { return angle(i, share) / 2; };
    std::vector<float> keys;
    for (const double share : {0.0, 1.0}) {
      const auto sine = static_cast<float>(std::sin(half(share)));
      keys.insert(keys.end(),
                  {0, about_y(i) ? sine : 0, about_y(i) ? 0 : sine, static_cast<float>(std::cos(half(share)))});
    }
    const std::size_t at = add(floats(keys), R"("componentType":5126,"count":2,"type":"VEC4")");
    const std::string comma = i == 0 ? "" : ",";
    samplers += comma + R"({"input":5,"output":)" + json_of(at) + "}";
    channels +=
        comma + R"({"sampler":)" + json_of(i) + R"(,"target":{"node":)" + json_of(i + 2) + R"(,"path":"rotation"}})";
    nodes += R"(,{"name":"joint)" + json_of(i) + R"(","translation":[)" + (i == 0 ? "0" : "200") + ",0,0]" +
             (i + 1 < kJoints ? R"(,"children":[)" + json_of(i + 3) + "]" : "") + "}";
    joints += comma + json_of(i + 2);
  }
  const std::string animations =
      R"("animations":[{"name":"swim","channels":[)" + channels + R"(],"samplers":[)" + samplers + "]}],";
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"name":"eel","mesh":0,"skin":0,)"
         R"("translation":[5,6,7]},{"name":"armature","children":[2],"rotation":[0.6,0,0,0.8],"scale":[0.01,0.01,0.01]})" +
         nodes + R"(],"skins":[{"inverseBindMatrices":4,"joints":[)" + joints +
         R"(]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},"indices":3}]}],)" +
         (animated ? animations : "") + R"("accessors":[)" + accessors + R"(],"bufferViews":[)" + views +
         R"(],"buffers":[{"byteLength":)" + json_of(buffer.size()) +
         R"(,"uri":"data:application/octet-stream;base64,)" + base64(buffer) + "\"}]}";
}

using Place = std::array<double, 3>;

/// Where a corner is `share` of the way through the animation, in the file's coordinates: in its joint, out through all
/// joints before that one, through the armature.
Place expected(std::size_t ring, std::size_t side, double share) {
  const auto through = [&](std::size_t joint) {
    Place p = Eel::corner(ring, side);
    p[0] -= 200 * static_cast<double>(joint);
    for (std::size_t i = joint + 1; i-- > 0;) {
      const double a = Eel::angle(i, share), s = std::sin(a), c = std::cos(a);
      p = Eel::about_y(i) ? Place{c * p[0] + s * p[2], p[1], -s * p[0] + c * p[2]}
                          : Place{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
      if (i != 0) p[0] += 200;
    }
    // About x, twice the angle whose half has sine 0.6 and cosine 0.8.
    const double s = 0.96, c = 0.28;
    return Place{Eel::kScale * p[0], Eel::kScale * (c * p[1] - s * p[2]), Eel::kScale * (s * p[1] + c * p[2])};
  };
  const auto [joint, next] = Eel::weights(ring);
  const Place a = through(joint), b = through(std::min(joint + 1, Eel::kJoints - 1));
  Place mixed{};
  for (std::size_t axis = 0; axis < 3; ++axis) mixed[axis] = a[axis] * (1 - next) + b[axis] * next;
  return mixed;
}

class GltfSkin : public FolderTest {
 protected:
  std::unique_ptr<Stage> opened(const Eel& eel) const {
    Result<std::unique_ptr<Stage>> stage = open_stage(file("eel.gltf", eel.gltf()), {}, {}, {320, 240}, 8);
    EXPECT_TRUE(stage) << stage.failure().message;
    return stage ? std::move(*stage) : nullptr;
  }
  static std::vector<Place> corners(Stage& stage, const Scene& scene) {
    const Units& units = stage.model()->units;
    std::vector<Place> all;
    for (const Instance& instance : scene.instances) {
      const Mesh& mesh = scene.meshes[instance.mesh];
      for (const Position& p : mesh.positions) {
        const std::array<Fixed, 3> centre{mesh.centre.x, mesh.centre.y, mesh.centre.z},
            half{mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z};
        const std::array<std::int16_t, 3> steps{p.x, p.y, p.z};
        Place& to = all.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double scene_units = from_fixed(centre[axis]) + from_fixed(half[axis]) * steps[axis] / 32768;
          to[axis] = scene_units / units.scale + units.origin[axis];
        }
      }
    }
    return all;
  }
  /// The farthest that a corner of the eel is from the nearest vertex, and a vertex from the nearest corner.
  static double farthest(const std::vector<Place>& found, double share) {
    std::vector<Place> wanted;
    for (std::size_t ring = 0; ring < Eel::kRings; ++ring) {
      for (std::size_t side = 0; side < 3; ++side) wanted.push_back(expected(ring, side, share));
    }
    const auto away = [](const std::vector<Place>& from, const std::vector<Place>& to) {
      double most = 0;
      for (const Place& a : from) {
        double least = 1e9;
        for (const Place& b : to) least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
        most = std::max(most, least);
      }
      return most;
    };
    return std::max(away(wanted, found), away(found, wanted));
  }
};

/// A tenth of a pixel where 16 units of length fill 320 pixels, and what rounding adds.
constexpr double kCornerTolerance = 0.006;

TEST_F(GltfSkin, CornersAreWhereTheirJointsTakeThem) {
  const auto stage = opened({});
  ASSERT_TRUE(stage);
  EXPECT_TRUE(stage->warnings().empty()) << stage->warnings()[0];
  EXPECT_TRUE(stage->bends());
  EXPECT_EQ(stage->model()->joints.size(), Eel::kJoints);
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    const Result<Staging> staging = stage->place(frame, 8);
    ASSERT_TRUE(staging) << staging.failure().message;
    EXPECT_LT(farthest(corners(*stage, staging->scene), frame / 8.0), kCornerTolerance) << frame;
  }
  const auto second = stage->copy();
  const Result<Staging> here = stage->place(1, 8), there = second->place(6, 8);
  ASSERT_TRUE(here && there);
  EXPECT_LT(farthest(corners(*stage, here->scene), 1 / 8.0), kCornerTolerance) << "a copy has its own vertices";
  EXPECT_LT(farthest(corners(*second, there->scene), 6 / 8.0), kCornerTolerance);
}

TEST_F(GltfSkin, WithoutAnAnimationStandsWhereItsJointsAre) {
  const auto stage = opened({.animated = false});
  ASSERT_TRUE(stage);
  EXPECT_FALSE(stage->bends());
  EXPECT_TRUE(stage->model()->skins.empty());
  const Result<Staging> staging = stage->place(0, 1);
  ASSERT_TRUE(staging);
  EXPECT_LT(farthest(corners(*stage, staging->scene), 0), kCornerTolerance);
}

TEST_F(GltfSkin, WeightsAndMatricesThatAreLeftOutAreSaid) {
  const float nan = std::nanf("");
  for (const float weight : {-0.5F, nan, HUGE_VALF}) {
    const auto stage = opened({.first_weight = weight});
    ASSERT_TRUE(stage);
    ASSERT_EQ(stage->warnings().size(), 1U) << weight;
    EXPECT_EQ(stage->warnings()[0], "1 corner of skins: weights left out that are negative or not finite");
  }
  for (const float factor : {0.0F, nan}) {  // two rings have the first joint
    const auto stage = opened({.first_bind = factor});
    ASSERT_TRUE(stage);
    ASSERT_EQ(stage->warnings().size(), 1U) << factor;
    EXPECT_EQ(stage->warnings()[0], "6 corners of skins: joints left out whose matrix has no inverse");
  }
}

TEST_F(GltfSkin, CornersWhoseWeightsAreAllZeroWereSilent) {
  const auto stage = opened({.first_weight = 0});
  ASSERT_TRUE(stage);
  ASSERT_EQ(stage->warnings().size(), 1U);
  EXPECT_EQ(stage->warnings()[0], "1 corner of skins: all weights are zero, so that no joint moves it");
}

/// A needle along x whose joint turns by 340 degrees about z in a tenth of a second, by three keys.
std::string fast_needle() {
  const std::string corners = floats({0, 0, 0, 1, 0, 0, 0, 0.001F, 0}), joints(12, '\0');
  const std::string weights = floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}), triangle("\0\0\1\0\2\0\0\0", 8);
  const std::string times = floats({0, 0.05F, 0.1F});
  const auto sine = [](double degrees) { return static_cast<float>(std::sin(degrees * std::numbers::pi / 180)); };
  const std::string turns = floats({0, 0, 0, 1, 0, 0, sine(85), sine(5), 0, 0, sine(170), sine(-80)});
  std::string buffer, views, accessors;
  const auto add = [&](const std::string& bytes, const std::string& what) {
    const std::string comma = views.empty() ? "" : ",";
    accessors += comma + R"({"bufferView":)" + json_of(static_cast<std::size_t>(std::ranges::count(views, '{'))) + what;
    views += comma + R"({"buffer":0,"byteOffset":)" + json_of(buffer.size()) + R"(,"byteLength":)" +
             json_of(bytes.size()) + "}";
    buffer += bytes;
  };
  add(corners, R"(,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,0.001,0]})");
  add(joints, R"(,"componentType":5121,"count":3,"type":"VEC4"})");
  add(weights, R"(,"componentType":5126,"count":3,"type":"VEC4"})");
  add(triangle, R"(,"componentType":5123,"count":3,"type":"SCALAR"})");
  add(times, R"(,"componentType":5126,"count":3,"type":"SCALAR","min":[0],"max":[0.1]})");
  add(turns, R"(,"componentType":5126,"count":3,"type":"VEC4"})");
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"skin":0},{}],)"
         R"("skins":[{"joints":[1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},)"
         R"("indices":3}]}],"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"rotation"}}],)"
         R"("samplers":[{"input":4,"output":5}]}],"accessors":[)" +
         accessors + R"(],"bufferViews":[)" + views + R"(],"buffers":[{"byteLength":)" + json_of(buffer.size()) +
         R"(,"uri":"data:application/octet-stream;base64,)" + base64(buffer) + "\"}]}";
}

TEST_F(GltfSkin, FastTurnsStayInTheirBox) {
  const Result<std::unique_ptr<Stage>> stage = open_stage(file("needle.gltf", fast_needle()), {}, {}, {320, 240}, 100);
  ASSERT_TRUE(stage) << stage.failure().message;
  ASSERT_TRUE((*stage)->bends());
  for (std::uint32_t frame = 0; frame < 100; ++frame) {
    const Result<Staging> staging = (*stage)->place(frame, 100);
    ASSERT_TRUE(staging) << staging.failure().message;
  }
}

/// A triangle whose one joint leaps away and back within 1/60 s, by a spline between two keys at the same place.
std::string leap(const std::string& name) {
  GltfData data;
  const std::size_t corners = data.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const std::size_t joints = data.add(std::string(12, '\0'), R"("componentType":5121,"count":3,"type":"VEC4")");
  const std::size_t weights = data.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  const std::size_t indices = data.add_indices({0, 1, 2});
  const std::size_t times = data.add_floats({0, 0.016F, 1}, "SCALAR");
  const std::size_t places =
      data.add_floats({0, 0, 0, 0, 0, 0, 2000, 0, 0, -2000, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"skin":0},{)" + name +
         R"(}],"skins":[{"joints":[1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":)" + json_of(corners) +
         R"(,"JOINTS_0":)" + json_of(joints) + R"(,"WEIGHTS_0":)" + json_of(weights) + R"(},"indices":)" +
         json_of(indices) +
         R"(}]}],"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}],"samplers":[{)"
         R"("interpolation":"CUBICSPLINE","input":)" +
         json_of(times) + R"(,"output":)" + json_of(places) + "}]}]," + data.json() + "}";
}

TEST_F(GltfSkin, AMessageOfASkinThatLeavesItsBoxNamedNeitherFileNorJoint) {
  for (const auto& [name, said] :
       {std::pair(R"("name":"left\u001b hand")", "joint 'left? hand'"), std::pair("", "joint 'node 1'")}) {
    const Result<std::unique_ptr<Stage>> stage =
        open_stage(file("leap.gltf", leap(name)), {}, {.eye = {{0, 0, 9}}}, {320, 240}, 1000);
    ASSERT_TRUE(stage) << stage.failure().message;
    const Result<Staging> staging = (*stage)->place(8, 1000);
    ASSERT_FALSE(staging);
    EXPECT_EQ(staging.failure().status, ExitStatus::input);
    for (const std::string& part : {std::string("leap.gltf': 8 ms after"), std::string(said)}) {
      EXPECT_NE(staging.failure().message.find(part), std::string::npos) << staging.failure().message;
    }
  }
}

/// The camera of all frames has every frame inside.
TEST_F(GltfSkin, EveryFrameIsInThePicture) {
  const auto stage = opened({});
  ASSERT_TRUE(stage);
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    const Result<Staging> staging = stage->place(frame, 8);
    ASSERT_TRUE(staging);
    const Camera& camera = staging->camera;
    for (const Instance& instance : staging->scene.instances) {
      const Mesh& mesh = staging->scene.meshes[instance.mesh];
      for (const Position& p : mesh.positions) {
        const double at[3] = {from_fixed(mesh.centre.x - camera.eye.x) + from_fixed(mesh.half_extent.x) * p.x / 32768,
                              from_fixed(mesh.centre.y - camera.eye.y) + from_fixed(mesh.half_extent.y) * p.y / 32768,
                              from_fixed(mesh.centre.z - camera.eye.z) + from_fixed(mesh.half_extent.z) * p.z / 32768};
        const auto along = [&](const Vec3& axis) {
          return (at[0] * axis.x + at[1] * axis.y + at[2] * axis.z) / (1 << 30);
        };
        const double distance = -along(camera.back), focal = from_fixed(camera.focal);
        ASSERT_LT(std::abs(along(camera.right)) * focal, distance * 4 / 3);
        ASSERT_LT(std::abs(along(camera.up)) * focal, distance);
      }
    }
  }
}

}  // namespace
}  // namespace zstrip::sim::test
