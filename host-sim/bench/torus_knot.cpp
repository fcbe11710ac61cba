// A tube around the (3, 4) torus knot: three times around the axis, four times through the hole.
#include "bench/torus_knot.hpp"

#include <cstdint>
#include <cstdlib>

#include "import/meshlets.hpp"
#include "zstrip/base/math.hpp"

namespace zstrip::sim {
namespace {

// All lengths and unit vectors: 64 bits with 28 fraction bits, so that products of two stay below 2^62.
constexpr int kBits = 28;
constexpr std::int64_t kOne = std::int64_t{1} << kBits;
constexpr std::int64_t kTorusRadius = kOne;
constexpr std::int64_t kCrossSection = kOne * 42 / 100;
constexpr std::int64_t kTubeRadius = kOne * 20 / 100;
constexpr int kAroundAxis = 3;
constexpr int kThroughHole = 4;

// 16.16; a little more than the tube reaches.
constexpr Vec3 kHalfExtent{kFixedOne * 13 / 8, kFixedOne * 13 / 8, kFixedOne * 5 / 8};

struct Vector {
  std::int64_t x, y, z;
};

constexpr std::int64_t product(std::int64_t a, std::int64_t b) { return (a * b) >> kBits; }
constexpr Vector operator*(std::int64_t scale, const Vector& v) {
  return {product(scale, v.x), product(scale, v.y), product(scale, v.z)};
}
constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

std::int64_t sine_of(Angle angle) { return sine(angle) >> (30 - kBits); }
std::int64_t cosine_of(Angle angle) { return cosine(angle) >> (30 - kBits); }

constexpr Angle share_of_turn(std::size_t index, std::size_t count) {
  return static_cast<Angle>((index * kFullTurn + count / 2) / count);
}

struct TubePoint {
  Vector position, normal;
};

// The knot runs on a torus, whose normal and directions give the frame of the tube. So no frame has to be transported
// along the curve, and the ends meet.
TubePoint tube_point(std::size_t ring, std::size_t side) {
  const Angle t = share_of_turn(ring, kTorusKnotRings);
  const std::int64_t cos_a = cosine_of(kAroundAxis * t), sin_a = sine_of(kAroundAxis * t);
  const std::int64_t cos_b = cosine_of(kThroughHole * t), sin_b = sine_of(kThroughHole * t);
  const Vector outward{product(cos_b, cos_a), product(cos_b, sin_a), sin_b};
  const Vector around_axis{-sin_a, cos_a, 0};
  const Vector through_hole{-product(sin_b, cos_a), -product(sin_b, sin_a), cos_b};

  // The tangent is along_axis * around_axis + along_hole * through_hole; its cross product with `outward` follows.
  const std::int64_t from_axis = kTorusRadius + product(kCrossSection, cos_b);
  const std::int64_t along_axis = kAroundAxis * from_axis;
  const std::int64_t along_hole = kThroughHole * kCrossSection;
  const std::int64_t length =
      square_root(static_cast<std::uint64_t>(along_axis * along_axis + along_hole * along_hole));
  const Vector sideways = (along_hole * kOne / length) * around_axis + (-along_axis * kOne / length) * through_hole;

  const Angle s = share_of_turn(side, kTorusKnotRingVertices);
  const Vector normal = cosine_of(s) * outward + sine_of(s) * sideways;
  const Vector centre{product(from_axis, cos_a), product(from_axis, sin_a), product(kCrossSection, sin_b)};
  return {centre + kTubeRadius * normal, normal};
}

// Rounds to the nearest step, halves away from zero, so that symmetric values stay symmetric.
std::int16_t on_grid(std::int64_t value, Fixed half_extent) {
  const std::int64_t half = std::int64_t{half_extent} << (kBits - kFixedBits);
  const std::int64_t steps = (std::abs(value) * 65536 / half + 1) / 2;
  return static_cast<std::int16_t>(value < 0 ? -steps : steps);
}

// normal / 2 + 1/2.
std::uint8_t channel(std::int64_t component) { return static_cast<std::uint8_t>(128 + product(127, component)); }

MeshData vertices() {
  MeshData whole;
  for (std::size_t ring = 0; ring < kTorusKnotRings; ++ring) {
    for (std::size_t side = 0; side < kTorusKnotRingVertices; ++side) {
      const auto [p, n] = tube_point(ring, side);
      whole.positions.push_back(
          {on_grid(p.x, kHalfExtent.x), on_grid(p.y, kHalfExtent.y), on_grid(p.z, kHalfExtent.z)});
      whole.colours.push_back({channel(n.x), channel(n.y), channel(n.z), 255});
    }
  }
  return whole;
}

// Two for each quad of the closed grid, counter-clockwise from outside.
std::vector<std::uint32_t> indices() {
  const auto vertex = [](std::size_t ring, std::size_t side) {
    return static_cast<std::uint32_t>(ring % kTorusKnotRings * kTorusKnotRingVertices + side % kTorusKnotRingVertices);
  };
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < kTorusKnotRings; ++i) {
    for (std::size_t j = 0; j < kTorusKnotRingVertices; ++j) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      corners.insert(corners.end(), {a, c, b, a, d, c});
    }
  }
  return corners;
}

}  // namespace

TorusKnot::TorusKnot() : data_(split_into_meshlets(vertices(), indices(), kHalfExtent)) {
  for (const MeshData& data : data_) {
    meshes_.push_back({.positions = data.positions,
                       .normals = {},
                       .colours = data.colours,
                       .texcoords = {},
                       .triangles = data.triangles,
                       .meshlets = data.meshlets,
                       .centre = {0, 0, 0},
                       .half_extent = kHalfExtent});
  }
}

}  // namespace zstrip::sim
