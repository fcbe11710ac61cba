// The knot's surface, computed at compile time: a tube of radius 0.13 around a trefoil of scale 0.28.
#pragma once

#include <array>

#include "zstrip_scenes/compile_time.hpp"
#include "zstrip_scenes/knot.hpp"

namespace zstrip::scenes::knot_shape {

/// World units.
struct Vector {
  double x, y, z;
};

/// A vertex before it is quantised.
struct Vertex {
  Vector position;
  Vector normal;
};

consteval Vector unit(const Vector& v) {
  const double length = compile_time::square_root(v.x * v.x + v.y * v.y + v.z * v.z);
  return {v.x / length, v.y / length, v.z / length};
}

/// Returns a point of the trefoil; t in radians.
consteval Vector centre_line(double t) {
  using compile_time::cosine, compile_time::sine;
  constexpr double kScale = 0.28;
  return {kScale * (sine(t) + 2 * sine(2 * t)), kScale * (cosine(t) - 2 * cosine(2 * t)), -kScale * sine(3 * t)};
}

/// Returns the vertices ring after ring, vertex i * kKnotRingVertices + j. The tangent is the workload's forward
/// difference over 0.001 radians, not the derivative: the two differ by several steps of the position grid.
consteval std::array<Vertex, kKnotVertices> vertices() {
  constexpr double kRadius = 0.13;
  std::array<Vertex, kKnotVertices> result{};
  for (std::size_t i = 0; i < kKnotRings; ++i) {
    const double t = 2 * compile_time::kPi * static_cast<double>(i) / kKnotRings;
    const Vector c = centre_line(t);
    const Vector ahead = centre_line(t + 0.001);
    const Vector tangent = unit({ahead.x - c.x, ahead.y - c.y, ahead.z - c.z});
    const Vector side = unit({-tangent.y, tangent.x, 0});  // the trefoil is never parallel to z
    const Vector other = {-tangent.z * side.y, tangent.z * side.x, tangent.x * side.y - tangent.y * side.x};
    for (std::size_t j = 0; j < kKnotRingVertices; ++j) {
      const double angle = 2 * compile_time::kPi * static_cast<double>(j) / kKnotRingVertices;
      const double cosine = compile_time::cosine(angle), sine = compile_time::sine(angle);
      const Vector n = {side.x * cosine + other.x * sine, side.y * cosine + other.y * sine, other.z * sine};
      result[i * kKnotRingVertices + j] = {{c.x + kRadius * n.x, c.y + kRadius * n.y, c.z + kRadius * n.z}, n};
    }
  }
  return result;
}

consteval std::int16_t on_grid(double value, Fixed centre, Fixed half_extent) {
  return compile_time::grid_step(compile_time::nearest((value * kFixedOne - centre) * 32768 / half_extent));
}

consteval std::array<Position, kKnotVertices> positions(const std::array<Vertex, kKnotVertices>& vertices) {
  std::array<Position, kKnotVertices> result{};
  for (std::size_t i = 0; i < kKnotVertices; ++i) {
    const Vector& p = vertices[i].position;
    result[i] = {on_grid(p.x, kKnotCentre.x, kKnotHalfExtent.x), on_grid(p.y, kKnotCentre.y, kKnotHalfExtent.y),
                 on_grid(p.z, kKnotCentre.z, kKnotHalfExtent.z)};
  }
  return result;
}

consteval std::array<Normal, kKnotVertices> normals(const std::array<Vertex, kKnotVertices>& vertices) {
  const auto quantised = [](double value) consteval {
    return static_cast<std::int8_t>(compile_time::nearest(127 * value));  // 1.7
  };
  std::array<Normal, kKnotVertices> result{};
  for (std::size_t i = 0; i < kKnotVertices; ++i) {
    const Vector& n = vertices[i].normal;
    result[i] = {quantised(n.x), quantised(n.y), quantised(n.z), 0};
  }
  return result;
}

consteval std::array<Colour, kKnotVertices> colours(const std::array<Vertex, kKnotVertices>& vertices) {
  const auto channel = [](double value) consteval { return static_cast<std::uint8_t>(127.5 + 127 * value); };  // floor
  std::array<Colour, kKnotVertices> result{};
  for (std::size_t i = 0; i < kKnotVertices; ++i) {
    const Vector& n = vertices[i].normal;
    result[i] = {channel(n.x), channel(n.y), channel(n.z), 255};
  }
  return result;
}

}  // namespace zstrip::scenes::knot_shape
