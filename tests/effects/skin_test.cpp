// Skins against an oracle in double: matrices multiplied out, vertices moved by all of their joints.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "../oracle/draw.hpp"
#include "zstrip/base/unit_vector.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_scenes/character.hpp"

namespace zstrip::test {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<std::array<double, 4>, 3>;  // affine

constexpr double kOne = kFixedOne;

Fixed fixed(double value) { return static_cast<Fixed>(std::lround(value * kOne)); }

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    }
    c[i][3] += a[i][3];
  }
  return c;
}

Vector moved(const Matrix& m, const Vector& v, double w) {
  Vector to{};
  for (std::size_t i = 0; i < 3; ++i) to[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2] + w * m[i][3];
  return to;
}

double length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

Matrix matrix_of(const Transform& transform) {
  Matrix m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) m[i][j] = transform.m[i][j] / kOne;
  }
  return m;
}

/// Columns of a rotation by an axis' quaternion, scaled; the textbook's formula.
Matrix matrix_of(const JointPose& pose) {
  std::array<double, 4> q{};
  double norm = 0;
  for (std::size_t i = 0; i < 4; ++i) q[i] = pose.rotation[i], norm += q[i] * q[i];
  for (double& c : q) c /= std::sqrt(norm);
  const auto [x, y, z, w] = q;
  const double s[3] = {pose.scale.x / kOne, pose.scale.y / kOne, pose.scale.z / kOne};
  Matrix m{{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), pose.translation.x / kOne},
            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), pose.translation.y / kOne},
            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), pose.translation.z / kOne}}};
  for (auto& row : m) {
    for (std::size_t j = 0; j < 3; ++j) row[j] *= s[j];
  }
  return m;
}

/// Of a matrix whose columns are at right angles and of one length.
Matrix inverse(const Matrix& m) {
  const double square = m[0][0] * m[0][0] + m[1][0] * m[1][0] + m[2][0] * m[2][0];
  Matrix r{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      r[i][j] = m[j][i] / square;
      r[i][3] -= r[i][j] * m[j][3];
    }
  }
  return r;
}

std::vector<Matrix> globals(std::span<const Joint> joints, std::span<const JointPose> poses) {
  std::vector<Matrix> all;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Matrix own = matrix_of(poses[i]);
    all.push_back(joints[i].parent == kNoJoint ? own : product(all[joints[i].parent], own));
  }
  return all;
}

/// A skin of random joints and vertices, and memory for what it moves.
struct Creature {
  Mesh mesh;
  Skin skin;
  std::vector<Position> positions, moved_positions;
  std::vector<Normal> normals, moved_normals;
  std::vector<Triangle> triangles;
  std::vector<Meshlet> meshlets, moved_meshlets;
  std::vector<VertexJoints> vertices;
  std::vector<Joint> joints;
  std::vector<JointPose> rest;
  std::vector<Transform> work;

  MovedVertices moved() { return {moved_positions, moved_normals, moved_meshlets}; }
  Status move(std::span<const JointPose> pose) { return skin_mesh(skin, pose, work, moved()); }
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double within(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(engine_); }

  /// Turned by up to `angle` about any axis.
  void turn(JointPose& pose, double angle) {
    Vector axis{within(-1, 1), within(-1, 1), within(-1, 1)};
    const double half = within(-angle, angle) / 2, sine = std::sin(half) / std::max(length(axis), 1e-3);
    for (std::size_t i = 0; i < 3; ++i)
      pose.rotation[i] = static_cast<std::int16_t>(std::lround(axis[i] * sine * 32767));
    pose.rotation[3] = static_cast<std::int16_t>(std::lround(std::cos(half) * 32767));
  }

 private:
  std::mt19937 engine_;
};

constexpr std::size_t kVertices = 300;

Creature creature(Random& random, double size) {
  Creature c;
  const std::size_t joints = 1 + random.below(20);
  for (std::size_t i = 0; i < joints; ++i) {
    Joint joint;
    if (i != 0) joint.parent = static_cast<std::uint16_t>(random.below(i));
    c.joints.push_back(joint);
    JointPose pose;
    random.turn(pose, 1);
    const double reach = size / 8;
    pose.translation = {fixed(random.within(-reach, reach)), fixed(random.within(-reach, reach)),
                        fixed(random.within(-reach, reach))};
    c.rest.push_back(pose);
  }
  const std::vector<Matrix> bind = globals(c.joints, c.rest);
  for (std::size_t i = 0; i < joints; ++i) {
    const Matrix m = inverse(bind[i]);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column)
        c.joints[i].inverse_bind.m[row][column] = fixed(m[row][column]);
    }
  }
  for (std::size_t i = 0; i < kVertices; ++i) {
    const auto place = [&] { return static_cast<std::int16_t>(random.within(-6000, 6000)); };
    c.positions.push_back({place(), place(), place()});
    Vector n{random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)};
    const double by = 127 * (i % 8 == 0 ? 1.3 : 1) / std::max(length(n), 1e-2);
    const auto component = [&](double v) { return static_cast<std::int8_t>(std::clamp(v * by, -127.0, 127.0)); };
    c.normals.push_back({component(n[0]), component(n[1]), component(n[2]), 0});
    VertexJoints v;
    int left = 255;
    const std::size_t count = 1 + random.below(4);
    for (std::size_t k = 0; k < 4; ++k) {
      v.joints[k] = static_cast<std::uint8_t>(random.below(joints));
      const int weight = k + 1 == count ? left
                         : k < count    ? static_cast<int>(random.below(static_cast<std::size_t>(left) / 2 + 1))
                                        : 0;
      v.weights[k] = static_cast<std::uint8_t>(weight);
      left -= weight;
    }
    std::sort(std::begin(v.weights), std::end(v.weights), std::greater<>());
    c.vertices.push_back(v);
  }
  for (std::size_t i = 0; i + 2 < kVertices; i += 3) {
    c.triangles.push_back(
        {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(i + 1), static_cast<std::uint16_t>(i + 2)});
  }
  for (std::uint16_t first = 0; first < kVertices; first += 30) {
    c.meshlets.push_back({.first_triangle = first / 3U,
                          .first_vertex = first,
                          .vertex_count = 30,
                          .triangle_count = 10,
                          .radius = 0,
                          .centre = {}});
  }
  c.moved_positions.resize(kVertices);
  c.moved_normals.resize(kVertices);
  c.moved_meshlets.resize(c.meshlets.size());
  c.work.resize(joints);
  const Fixed half = fixed(size);
  c.mesh = {.positions = {},
            .normals = {},
            .colours = {},
            .texcoords = {},
            .triangles = {},
            .meshlets = {},
            .centre = {fixed(size / 5), fixed(-size / 7), 0},
            .half_extent = {half, half, half}};
  return c;
}

/// The spans of what has come to rest.
void connect(Creature& c) {
  c.mesh.positions = c.positions;
  c.mesh.normals = c.normals;
  c.mesh.triangles = c.triangles;
  c.mesh.meshlets = c.meshlets;
  c.skin = {&c.mesh, c.vertices, c.joints, c.rest};
}

Vector place_of(const Mesh& mesh, const Position& p) {
  const double by = mesh.half_extent.x / kOne / 32768;
  return {mesh.centre.x / kOne + by * p.x, mesh.centre.y / kOne + by * p.y, mesh.centre.z / kOne + by * p.z};
}

double weight_of(const VertexJoints& v, std::size_t k) { return (v.weights[k] + (k == 0 ? 1 : 0)) / 256.0; }

/// In units of positions; their errors are those of matrices of 14 bits over three components, and of the chain of
/// joints, 2^-16 of a unit of length each.
double allowed(const Creature& c) {
  return 3.5 + static_cast<double>(c.joints.size()) * 3 * 32768 / c.mesh.half_extent.x;
}

/// Where a vertex comes to lie, in the mesh's space, and its normal's direction, of any length.
struct Expected {
  Vector place{}, direction{};
};
Expected expected_of(const Creature& c, const std::vector<Matrix>& global, std::size_t vertex) {
  Expected e;
  const Normal& n = c.normals[vertex];
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t joint = c.vertices[vertex].joints[k];
    const Matrix m = product(global[joint], matrix_of(c.joints[joint].inverse_bind));
    const double weight = weight_of(c.vertices[vertex], k);
    const Vector to = moved(m, place_of(c.mesh, c.positions[vertex]), 1);
    const Vector way = moved(m, {double(n.x), double(n.y), double(n.z)}, 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      e.place[axis] += weight * to[axis];
      e.direction[axis] += weight * way[axis];
    }
  }
  return e;
}

/// In units of positions, along one axis.
double units(const Creature& c, double length) { return std::abs(length) * 32768 * kOne / c.mesh.half_extent.x; }

bool leaves_box(const Creature& c, const Vector& place) {
  const Fixed centre[3] = {c.mesh.centre.x, c.mesh.centre.y, c.mesh.centre.z};
  double farthest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    farthest = std::max(farthest, units(c, place[axis] - centre[axis] / kOne));
  }
  return farthest > 32767 - allowed(c);
}

TEST(Skins, VerticesAreWhereJointsMoveThem) {
  Random random(1);
  double worst = 0, worst_normal = 0;
  int poses = 0;
  for (int i = 0; i < 300; ++i) {
    Creature c = creature(random, std::exp(random.within(std::log(0.5), std::log(200))));
    connect(c);
    ASSERT_TRUE(validate(c.skin)) << i;
    std::vector<JointPose> pose = c.rest;
    for (JointPose& joint : pose) random.turn(joint, 1.5);
    const std::vector<Matrix> global = globals(c.joints, pose);
    if (const Status status = c.move(pose); !status) {
      EXPECT_TRUE(leaves_box(c, expected_of(c, global, status.needed).place)) << i;
      continue;
    }
    ++poses;
    for (std::size_t v = 0; v < kVertices; ++v) {
      const Expected expected = expected_of(c, global, v);
      const Vector found = place_of(c.mesh, c.moved_positions[v]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double error = units(c, found[axis] - expected.place[axis]);
        worst = std::max(worst, error / allowed(c));
        ASSERT_LE(error, allowed(c)) << "creature " << i << " vertex " << v;
      }
      const Normal &from = c.normals[v], &to = c.moved_normals[v];
      const double before = length({double(from.x), double(from.y), double(from.z)});
      const double sum = length(expected.direction);
      if (sum < 0.05 * before) continue;  // joints that turn it opposite ways
      const double got[3] = {double(to.x), double(to.y), double(to.z)};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double wanted = std::clamp(expected.direction[axis] / sum * before, -128.0, 127.0);
        worst_normal = std::max(worst_normal, std::abs(got[axis] - wanted));
      }
      ASSERT_LE(worst_normal, 1.1) << "creature " << i << " vertex " << v;
    }
  }
  EXPECT_GT(poses, 200);
  RecordProperty("worst_of_allowed", std::to_string(worst));
  RecordProperty("worst_normal", std::to_string(worst_normal));
}

TEST(Skins, AtRestTheMeshIsAsItWasModelled) {
  Random random(2);
  Creature c = creature(random, 2);
  for (Joint& joint : c.joints) joint = {};
  for (JointPose& joint : c.rest) joint = {};
  connect(c);
  ASSERT_TRUE(c.move(c.rest));
  for (std::size_t v = 0; v < kVertices; ++v) {
    EXPECT_EQ(c.moved_positions[v].x, c.positions[v].x);
    EXPECT_EQ(c.moved_positions[v].y, c.positions[v].y);
    EXPECT_EQ(c.moved_positions[v].z, c.positions[v].z);
  }
}

TEST(Skins, SpheresOfMeshletsHoldTheirVertices) {
  Random random(3);
  int poses = 0;
  for (int i = 0; i < 50; ++i) {
    Creature c = creature(random, 3);
    connect(c);
    std::vector<JointPose> pose = c.rest;
    for (JointPose& joint : pose) random.turn(joint, 3);
    if (!c.move(pose)) continue;
    ++poses;
    for (const Meshlet& m : c.moved_meshlets) {
      double farthest = 0;
      for (std::size_t v = m.first_vertex; v < std::size_t{m.first_vertex} + m.vertex_count; ++v) {
        const Position& p = c.moved_positions[v];
        farthest =
            std::max(farthest, length({double(p.x - m.centre.x), double(p.y - m.centre.y), double(p.z - m.centre.z)}));
      }
      EXPECT_LE(farthest, m.radius);
      EXPECT_LT(m.radius, farthest + 1);
    }
    Mesh drawn = moved_mesh(c.mesh, c.moved());
    const Instance instance;
    const Material material;
    EXPECT_TRUE(validate(Scene{.meshes = {&drawn, 1},
                               .materials = {&material, 1},
                               .textures = {},
                               .instances = {&instance, 1},
                               .lights = {}}));
  }
  EXPECT_GT(poses, 20);
}

TEST(Skins, WhatLeavesTheBoxOrTheRangeIsAnError) {
  Random random(4);
  Creature c = creature(random, 1);
  connect(c);
  std::vector<JointPose> pose = c.rest;
  const auto error = [&](const std::vector<JointPose>& of) { return c.move(of).error; };
  pose[0].translation.x += fixed(1.5);
  EXPECT_EQ(error(pose), Error::skin);
  pose[0].translation.x = INT32_MAX;
  EXPECT_EQ(error(pose), Error::skin);
  pose = c.rest;
  for (JointPose& joint : pose) joint.scale = {255 * kFixedOne, 255 * kFixedOne, 255 * kFixedOne};
  EXPECT_EQ(error(pose), Error::skin);
  pose = c.rest;
  for (auto& component : pose.back().rotation) component = 0;
  EXPECT_EQ(c.move(pose).needed, pose.size() - 1);
  EXPECT_EQ(error({}), Error::skin);
  c.work.pop_back();
  EXPECT_EQ(error(c.rest), Error::skin);
  c.work.push_back({});
  EXPECT_TRUE(c.move(c.rest));

  const auto refused = [&](auto change) {
    Creature other = c;
    connect(other);
    change(other);
    return validate(other.skin).error == Error::skin;
  };
  EXPECT_FALSE(refused([](Creature&) {}));
  EXPECT_TRUE(refused([](Creature& o) { o.joints[0].parent = 0; }));
  EXPECT_TRUE(refused([](Creature& o) { o.joints[0].inverse_bind.m[1][1] = 256 * kFixedOne; }));
  EXPECT_TRUE(refused([](Creature& o) { o.vertices[5].weights[0] -= 1; }));
  EXPECT_TRUE(refused([](Creature& o) { o.vertices[5].joints[3] = static_cast<std::uint8_t>(o.joints.size()); }));
  EXPECT_TRUE(refused([](Creature& o) { o.vertices[5] = {{0, 0, 0, 0}, {200, 0, 55, 0}}; }));
  EXPECT_TRUE(refused([](Creature& o) { o.mesh.half_extent.y += 1; }));
  EXPECT_TRUE(refused([](Creature& o) { o.skin.vertices = o.skin.vertices.first(1); }));
  EXPECT_TRUE(refused([](Creature& o) { o.skin.rest = o.skin.rest.first(0); }));
  EXPECT_TRUE(refused([](Creature& o) { o.skin.mesh = nullptr; }));
}

/// skin_mesh multiplies them in 64 bits without looking.
TEST(Skins, RestOutOfRangeIsRefused) {
  Random random(7);
  Creature c = creature(random, 1);
  connect(c);
  ASSERT_TRUE(validate(c.skin));
  const auto refused = [&](auto change) {
    Creature other = c;
    connect(other);
    change(other.rest.back());
    const Status status = validate(other.skin);
    return status.error == Error::skin && status.needed == other.rest.size() - 1;
  };
  EXPECT_FALSE(refused([](JointPose& r) { r.scale = {255 * kFixedOne, -255 * kFixedOne, 0}; }));
  EXPECT_FALSE(refused([](JointPose& r) { r.translation = {INT32_MAX, INT32_MIN, 0}; }));
  for (const Fixed scale : {255 * kFixedOne + 1, -255 * kFixedOne - 1, INT32_MAX, INT32_MIN}) {
    EXPECT_TRUE(refused([&](JointPose& r) { r.scale.x = scale; })) << scale;
    EXPECT_TRUE(refused([&](JointPose& r) { r.scale.y = scale; })) << scale;
    EXPECT_TRUE(refused([&](JointPose& r) { r.scale.z = scale; })) << scale;
  }
  const auto turned = [&](std::int16_t x, std::int16_t w) {
    return refused([&](JointPose& r) { r.rotation[0] = x, r.rotation[1] = 0, r.rotation[2] = 0, r.rotation[3] = w; });
  };
  EXPECT_TRUE(turned(0, 0));
  EXPECT_TRUE(turned(0, 16383));
  EXPECT_FALSE(turned(0, 16384));
  EXPECT_FALSE(turned(-32768, -32768));
}

/// No input makes a sum wrap: run under sanitizers.
TEST(Skins, AnyPoseIsMovedOrRefused) {
  Random random(5);
  int moved = 0;
  for (int i = 0; i < 2000; ++i) {
    Creature c = creature(random, std::exp(random.within(-8, 8)));
    connect(c);
    std::vector<JointPose> pose = c.rest;
    for (JointPose& joint : pose) {
      random.turn(joint, 7);
      const double reach = std::exp(random.within(-5, 10.3)), size = std::exp(random.within(-3, 5.5));
      for (Fixed* to : {&joint.translation.x, &joint.translation.y, &joint.translation.z})
        *to = fixed(random.within(-reach, reach));
      if (i % 2 == 0) continue;
      for (Fixed* to : {&joint.scale.x, &joint.scale.y, &joint.scale.z}) *to = fixed(random.within(-size, size));
    }
    if (c.move(pose)) ++moved;
  }
  EXPECT_GT(moved, 20);
  EXPECT_LT(moved, 1980);
}

TEST(Skins, ClipsAreBlendedAlongTheShorterArc) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    JointPose a, b;
    random.turn(a, 3);
    random.turn(b, 3);
    if (i % 2 == 0) {
      for (auto& component : b.rotation) component = static_cast<std::int16_t>(-component);  // the same place
    }
    a.translation = {fixed(random.within(-9, 9)), 0, fixed(1)};
    b.translation = {fixed(random.within(-9, 9)), fixed(3), 0};
    b.scale.y = fixed(2);
    const double share = random.within(0, 1);
    JointPose mixed = a;
    blend({&mixed, 1}, {&b, 1}, static_cast<std::uint32_t>(share * 65536));
    double cosine = 0, norm = 0;
    std::array<double, 4> q{};
    for (std::size_t k = 0; k < 4; ++k) cosine += double(a.rotation[k]) * b.rotation[k];
    for (std::size_t k = 0; k < 4; ++k) {
      q[k] = a.rotation[k] * (1 - share) + b.rotation[k] * share * (cosine < 0 ? -1 : 1);
      norm += q[k] * q[k];
    }
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(mixed.rotation[k], q[k] / std::sqrt(norm) * 32767, 3);
    EXPECT_NEAR(mixed.translation.x, a.translation.x * (1 - share) + b.translation.x * share, 20);
    EXPECT_NEAR(mixed.scale.y, kOne * (1 + share), 4);
  }
  JointPose a, b;
  random.turn(b, 2);
  JointPose end = a;
  blend({&end, 1}, {&b, 1}, 65536);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(end.rotation[k], b.rotation[k], 1);
}

TEST(Skins, KeyframesPoseJointsAsTheyPoseInstances) {
  Random random(7);
  std::vector<Keyframe> keyframes;
  std::uint32_t time = 100;
  JointPose last;
  for (int i = 0; i < 9; ++i) {
    JointPose key = last;
    JointPose turned;
    random.turn(turned, 1.2);
    std::copy(std::begin(turned.rotation), std::end(turned.rotation), std::begin(key.rotation));
    Keyframe frame{.time = time,
                   .rotation = {},
                   .translation = {fixed(random.within(-4, 4)), 0, fixed(i)},
                   .scale = {kFixedOne, fixed(0.5 + i), kFixedOne}};
    std::copy(std::begin(key.rotation), std::end(key.rotation), std::begin(frame.rotation));
    keyframes.push_back(frame);
    time += 50 + static_cast<std::uint32_t>(random.below(900));
  }
  const Track track{.instance = 0, .count = 9, .first = 0};
  const Animation animation{.tracks = {&track, 1}, .keyframes = keyframes, .duration = time};
  ASSERT_TRUE(validate(animation, 1));
  for (std::uint32_t t = 0; t < time; t += 37) {
    JointPose joint;
    Instance instance;
    pose(animation, t, std::span(&joint, 1));
    pose(animation, t, std::span(&instance, 1));
    const Matrix of_joint = matrix_of(joint), of_instance = matrix_of(instance.transform);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        EXPECT_NEAR(of_joint[row][column], of_instance[row][column], 2e-4 * 9) << t;
      }
    }
  }
}

/// A frame of the character as `effects` draw it with this budget.
template <Effects effects>
std::vector<std::uint16_t> character_at(const Scene& scene, const Camera& camera, const Budget& budget) {
  constexpr View kView{96, 128, PixelFormat::rgb565};
  const auto [status, plan] = zstrip::plan(scenes::character.counts, kView, effects, budget);
  EXPECT_TRUE(status);
  Renderer<effects> renderer;
  const picture::Picture drawn = picture::draw(renderer, scene, camera, kView, plan);
  EXPECT_TRUE(drawn.status) << message(drawn.status.error) << ' ' << drawn.status.needed;
  return rgb565_of(drawn);
}

/// One of the character's frames from afar, and from so near that much of it is clipped.
TEST(Skins, WhatIsMovedWhileItIsDrawnIsWhatIsMovedBefore) {
  using namespace scenes;
  constexpr Effects kSkins = effects_of(character.scene, character.camera);
  constexpr Effects kNone = without(kSkins, effect::skins);
  static_assert(kSkins != kNone);
  std::vector<Position> positions(kCharacterVertices);
  std::vector<Normal> normals(kCharacterVertices);
  std::vector<Meshlet> meshlets(kCharacterMeshletCount);
  std::vector<JointPose> joints(kCharacterRest.begin(), kCharacterRest.end());
  std::vector<Transform> work(kCharacterJoints);
  const MovedVertices moved{positions, normals, meshlets};
  const Mesh meshes[] = {moved_mesh(kCharacterBindMesh[0], moved)};
  Scene before = character.scene;
  before.meshes = meshes;
  Camera near = character.camera;
  near.eye = {fixed(0.1), fixed(0.3), fixed(0.55)};
  near.focal = fixed(0.8);
  const std::vector<std::uint16_t> at_rest = character_at<kSkins>(character.scene, character.camera, {});
  for (const std::uint32_t frame : {3U, 11U}) {
    ASSERT_TRUE(pose_character(frame));
    pose(kCharacterWalk, frame * kCharacterFrameTime, joints);
    ASSERT_TRUE(skin_mesh(kCharacterSkin, joints, work, moved));
    for (const Camera& camera : {character.camera, near}) {
      const std::vector<std::uint16_t> expected = character_at<kNone>(before, camera, {});
      EXPECT_NE(expected, at_rest);
      EXPECT_EQ(character_at<kSkins>(character.scene, camera, {}), expected);
      EXPECT_EQ(character_at<kSkins>(character.scene, camera, {.strip_rows = 17, .strip_columns = 40}), expected);
      EXPECT_EQ(
          character_at<kSkins | effect::bins>(character.scene, camera, {.strip_rows = 17, .modes = Modes::binned}),
          expected);
    }
  }
}

TEST(Skins, AFrameRefusesWhatCannotBeMovedWhileItIsDrawn) {
  Random random(8);
  Creature c = creature(random, 2);
  connect(c);
  Skinning skinning{.skin = &c.skin, .matrices = c.work, .positions = c.moved_positions, .normals = c.moved_normals};
  c.mesh.skinning = &skinning;
  const Instance instance;
  const Material material{.lit = true};
  const DirectionalLight light;
  Scene scene{.meshes = {&c.mesh, 1},
              .materials = {&material, 1},
              .textures = {},
              .instances = {&instance, 1},
              .lights = {&light, 1}};
  constexpr Effects kEffects =
      effect::lighting | effect::gouraud | effect::skins | effect::lines | effect::csg | effect::edges;
  constexpr View kView{32, 24, PixelFormat::rgb565};
  const auto error = [&] {
    const auto [status, plan] = zstrip::plan(count(scene), kView, effects_of(scene, {}));
    EXPECT_TRUE(status);
    Renderer<kEffects> renderer;
    return picture::draw(renderer, scene, {.eye = {0, 0, fixed(8)}}, kView, plan).status.error;
  };
  ASSERT_TRUE(pose_skin(skinning, c.rest));
  EXPECT_EQ(error(), Error::none);
  const Segment segment{0, 1};
  const LineSet lines{.segments = {&segment, 1}};
  scene.lines = {&lines, 1};
  EXPECT_EQ(error(), Error::skin);
  scene.lines = {};
  const Edge edge{0, 1, 2};
  const EdgeSet edges{{&edge, 1}, 0};
  scene.edges = {&edges, 1};
  EXPECT_EQ(error(), Error::skin);
  scene.edges = {};
  const CsgOperand operand{};
  scene.csg = {&operand, 1};
  EXPECT_EQ(error(), Error::skin);
  scene.csg = {};
  skinning.positions = std::span(c.moved_positions).first(29);  // a meshlet has 30
  EXPECT_EQ(error(), Error::skin);
  skinning.positions = std::span(c.moved_positions).first(30);
  EXPECT_EQ(error(), Error::none);
  skinning.normals = {};
  EXPECT_EQ(error(), Error::skin);
  skinning.normals = c.moved_normals;
  skinning.matrices = skinning.matrices.first(skinning.matrices.size() - 1);
  EXPECT_EQ(pose_skin(skinning, c.rest).error, Error::skin);
  EXPECT_EQ(error(), Error::skin);
}

/// What a vertex outside of the box does in a frame: nothing is known of it before.
TEST(Skins, WhatLeavesTheBoxWhileItIsDrawnStaysOnItsSide) {
  const Joint joints[1];
  const VertexJoints vertices[3];
  const JointPose rest[1];
  const Position positions[3] = {{-20000, -20000, 0}, {20000, -20000, 0}, {0, 20000, 0}};
  const Triangle triangles[1] = {{0, 1, 2}};
  Transform matrices[1];
  Position moved[3];
  const auto mesh_of = [&](const Position(&at)[3]) {
    return Mesh{.positions = at, .normals = {}, .colours = {}, .texcoords = {}, .triangles = triangles, .meshlets = {}};
  };
  const Mesh bind = mesh_of(positions);
  const Skin skin{&bind, vertices, joints, rest};
  Skinning skinning{.skin = &skin, .matrices = matrices, .positions = moved};
  JointPose pose[1];
  pose[0].translation.x = fixed(0.75);
  ASSERT_TRUE(pose_skin(skinning, pose));
  const Position outside[3] = {{4576, -20000, 0}, {32767, -20000, 0}, {24576, 20000, 0}};
  const Material material{.lit = false};
  const Instance instance;
  constexpr View kView{40, 32, PixelFormat::rgb565};
  const auto drawn = [&](Mesh mesh, Skinning* by) {
    mesh.skinning = by;
    const Scene scene{
        .meshes = {&mesh, 1}, .materials = {&material, 1}, .textures = {}, .instances = {&instance, 1}, .lights = {}};
    constexpr Effects kEffects = effect::skins;
    const auto [status, plan] = zstrip::plan(count(scene), kView, kEffects);
    EXPECT_TRUE(status);
    Renderer<kEffects> renderer;
    return rgb565_of(picture::draw(renderer, scene, {.eye = {0, 0, fixed(3)}}, kView, plan));
  };
  EXPECT_EQ(drawn(bind, &skinning), drawn(mesh_of(outside), nullptr));
  EXPECT_NE(drawn(bind, &skinning), drawn(bind, nullptr));
}

TEST(Roots, OfWordsAreRoundedDown) {
  for (std::uint64_t i = 0; i < 3'000'000; ++i) {
    const auto value = static_cast<std::uint32_t>(i < 70'000 ? i : i * 2'654'435'761U);
    const std::uint64_t root = detail::root_of_word(value);
    ASSERT_LE(root * root, value);
    ASSERT_GT((root + 1) * (root + 1), value);
  }
  for (std::uint64_t root = 1; root < 0x10000; ++root) {
    ASSERT_EQ(detail::root_of_word(static_cast<std::uint32_t>(root * root)), root);
    ASSERT_EQ(detail::root_of_word(static_cast<std::uint32_t>(root * root - 1)), root - 1);
  }
}

TEST(Roots, InversesAreQuotients) {
  for (std::uint32_t root = 1U << 14; root < 1U << 16; ++root) {
    ASSERT_EQ(detail::inverse_of_root<false>(root), (1U << 30) / root);
    ASSERT_EQ(detail::inverse_of_root<true>(root), (1U << 30) / root);
  }
}

}  // namespace
}  // namespace zstrip::test
