// Skins against an oracle in double: matrices multiplied out, vertices moved by all of their joints.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "creature.hpp"
#include "zstrip/base/unit_vector.hpp"
#include "zstrip/zstrip.hpp"

namespace zstrip::test {
namespace {

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

/// Meshes of one skeleton share its joints: a small one was refused for a joint of another that went far away.
TEST(Skins, AJointWithoutVerticesMayBeAnywhere) {
  Random random(5);
  Creature c = creature(random, 1);
  c.vertices[7] = {{0, 0, 0, 0}, {255, 0, 0, 0}};
  connect(c);
  ASSERT_TRUE(c.move(c.rest));
  const std::size_t far = c.joints.size();
  Creature other = c;
  other.joints.emplace_back();
  other.rest.push_back({.translation = {fixed(1000), 0, fixed(-30000)}});
  other.work.emplace_back();
  other.vertices[7] = {{0, static_cast<std::uint8_t>(far), 0, 0}, {255, 0, 0, 0}};
  connect(other);
  ASSERT_TRUE(validate(other.skin));
  ASSERT_TRUE(other.move(other.rest));
  EXPECT_TRUE(std::ranges::equal(other.moved_positions, c.moved_positions, [](const Position& a, const Position& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }));
  other.vertices[7] = {{0, static_cast<std::uint8_t>(far), 0, 0}, {254, 1, 0, 0}};
  const Status status = other.move(other.rest);
  EXPECT_EQ(status.error, Error::skin);
  EXPECT_EQ(status.needed, far);
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

TEST(Roots, OfWordsAreRoundedDown) {
  for (std::uint64_t i = 0; i < 3'000'000; ++i) {
    const auto value = static_cast<std::uint32_t>(i < 70'000 ? i : i * 2'654'435'761U);
    const std::uint64_t root = detail::root_of_word(value);
    ASSERT_EQ(detail::root_of_word<false>(value), root);
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
