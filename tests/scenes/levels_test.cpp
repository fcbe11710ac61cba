// Levels of detail: an instance has the coarsest mesh whose distance it has reached, and no mesh that breaks a plan.
#include "zstrip/levels.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace zstrip {
namespace {

constexpr Position kPositions[] = {{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}, {0, 0, 1000}};
constexpr Triangle kTriangles[] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
constexpr Normal kNormals[] = {{0, 0, 127, 0}, {0, 0, 127, 0}, {0, 0, 127, 0}, {0, 0, 127, 0}};

Mesh mesh_of(std::size_t triangles) {
  Mesh mesh{};
  mesh.positions = kPositions;
  mesh.normals = kNormals;
  mesh.triangles = std::span(kTriangles).first(triangles);
  mesh.centre = {0, 0, kFixedOne};
  return mesh;
}

class Levels : public ::testing::Test {
 protected:
  Levels() {
    scene_.meshes = meshes_;
    scene_.materials = materials_;
    scene_.instances = at_rest_;
  }
  /// The meshes of instances at these places along z; the camera is at z = 3 and looks towards -z.
  std::vector<int> meshes_at(std::initializer_list<int> z, const Camera& camera = {}) {
    at_rest_.clear();
    for (const int place : z) {
      at_rest_.push_back({.mesh = 0, .material = 0, .transform = Transform::identity()});
      at_rest_.back().transform.m[2][3] = place * kFixedOne;
    }
    scene_.instances = at_rest_;
    std::vector<Instance> instances = at_rest_;
    for (Instance& instance : instances) instance.mesh = 2;  // as the frame before may have left it
    choose_levels(levels_, scene_, camera, instances);
    std::vector<int> meshes;
    for (const Instance& instance : instances) meshes.push_back(instance.mesh);
    return meshes;
  }
  Status valid() const { return validate(levels_, scene_); }

  std::vector<Mesh> meshes_{mesh_of(4), mesh_of(3), mesh_of(2)};
  std::vector<Material> materials_{Material{}};
  std::vector<Instance> at_rest_;
  std::vector<DetailLevel> levels_{{0, 1, 10 * kFixedOne}, {0, 2, 20 * kFixedOne}};
  Scene scene_;
};

TEST_F(Levels, AreChosenByTheDistanceOfTheMeshsCentre) {
  // The centre is one unit nearer than the instance.
  EXPECT_EQ(meshes_at({0, -7, -8, -9, -17, -18, -1000, 20}), (std::vector{0, 0, 1, 1, 1, 2, 2, 0}));
}

TEST_F(Levels, AScaledInstanceHasItsCentreElsewhere) {
  meshes_at({0});
  at_rest_[0].transform.m[2][2] = 8 * kFixedOne;  // the centre is at z = 8
  scene_.instances = at_rest_;
  std::vector<Instance> instances = at_rest_;
  Camera far;
  far.eye.z = 18 * kFixedOne;
  choose_levels(levels_, scene_, far, instances);
  EXPECT_EQ(instances[0].mesh, 1);
  far.eye.z -= 1;
  choose_levels(levels_, scene_, far, instances);
  EXPECT_EQ(instances[0].mesh, 0);
}

TEST_F(Levels, DoNotOverflowAtTheLimitsOfFixedPoint) {
  Camera camera;
  camera.eye = {INT32_MIN, INT32_MIN, INT32_MIN};
  camera.back = {0, 0, -(1 << 30)};
  meshes_[0].centre = {(1 << 28) - 1, (1 << 28) - 1, (1 << 28) - 1};
  meshes_at({0});
  for (auto& row : at_rest_[0].transform.m) {
    for (Fixed& entry : row) entry = (1 << 24) - 1;
  }
  at_rest_[0].transform.m[2][3] = INT32_MAX;
  scene_.instances = at_rest_;
  std::vector<Instance> instances = at_rest_;
  choose_levels(levels_, scene_, camera, instances);
  EXPECT_EQ(instances[0].mesh, 2) << "some millions of units away";
}

TEST_F(Levels, AnOrthographicCameraShowsTheFinest) {
  Camera camera;
  camera.projection = Projection::orthographic;
  EXPECT_EQ(meshes_at({-9, -1000}, camera), (std::vector{0, 0}));
}

TEST_F(Levels, MeshesWithoutLevelsKeepTheirs) {
  levels_ = {{1, 2, 0}};
  EXPECT_EQ(meshes_at({-1000}), (std::vector{0}));
}

TEST_F(Levels, ThatBreakAPlanOrAnEffectAreRefused) {
  EXPECT_TRUE(valid());
  const auto refused = [this](std::uint32_t level) { return valid() == Status{.error = Error::mesh, .needed = level}; };
  const std::vector<DetailLevel> good = levels_;
  levels_[1].distance = levels_[0].distance;
  EXPECT_TRUE(refused(1)) << "distances ascend";
  levels_ = {good[0], {0, 1, 30 * kFixedOne}};
  EXPECT_TRUE(refused(1)) << "coarser meshes ascend";
  levels_ = {{1, 0, 0}};
  EXPECT_TRUE(refused(0)) << "more triangles";
  levels_ = {{0, 3, 0}};
  EXPECT_TRUE(refused(0)) << "no such mesh";
  levels_ = {{0, 1, -1}};
  EXPECT_TRUE(refused(0));
  levels_ = {{0, 1, 0}, {1, 2, 0}};
  EXPECT_TRUE(refused(0)) << "a level has no levels";
  levels_ = good;
  meshes_[2].normals = {};
  EXPECT_TRUE(refused(1)) << "an effect less";
  meshes_[2] = meshes_[0];
  meshes_[2].billboard = Billboard::viewer;
  EXPECT_TRUE(refused(1));
  meshes_[2] = mesh_of(2);
  meshes_[0].outline = 1;
  EXPECT_TRUE(refused(0)) << "its hull would stay";
  meshes_[0] = mesh_of(4);
  meshes_.resize(12, mesh_of(1));
  scene_.meshes = meshes_;
  levels_.clear();
  for (std::uint16_t i = 1; i <= 9; ++i) levels_.push_back({0, i, i * kFixedOne});
  EXPECT_TRUE(refused(8)) << "more than kMaxDetailLevels";
}

}  // namespace
}  // namespace zstrip
