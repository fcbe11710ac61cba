// Skins of random joints and vertices, and the matrices of joints in double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include "zstrip/skin.hpp"

namespace zstrip::test {

using Vector = std::array<double, 3>;
using Matrix = std::array<std::array<double, 4>, 3>;  // affine

inline constexpr double kOne = kFixedOne;

inline Fixed fixed(double value) { return static_cast<Fixed>(std::lround(value * kOne)); }

inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
    }
    c[i][3] += a[i][3];
  }
  return c;
}

inline Vector moved(const Matrix& m, const Vector& v, double w) {
  Vector to{};
  for (std::size_t i = 0; i < 3; ++i) to[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2] + w * m[i][3];
  return to;
}

inline double length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

inline Matrix matrix_of(const Transform& transform) {
  Matrix m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) m[i][j] = transform.m[i][j] / kOne;
  }
  return m;
}

/// Columns of a rotation by an axis' quaternion, scaled; the textbook's formula.
inline Matrix matrix_of(const JointPose& pose) {
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
inline Matrix inverse(const Matrix& m) {
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

inline std::vector<Matrix> globals(std::span<const Joint> joints, std::span<const JointPose> poses) {
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

inline constexpr std::size_t kVertices = 300;

inline Creature creature(Random& random, double size) {
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
inline void connect(Creature& c) {
  c.mesh.positions = c.positions;
  c.mesh.normals = c.normals;
  c.mesh.triangles = c.triangles;
  c.mesh.meshlets = c.meshlets;
  c.skin = {&c.mesh, c.vertices, c.joints, c.rest};
}

}  // namespace zstrip::test
