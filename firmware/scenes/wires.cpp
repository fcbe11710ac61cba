// The wires' surfaces, computed at compile time: prisms along the circles of a globe.
#include "zstrip_scenes/wires.hpp"

#include "zstrip/scene/validate.hpp"

namespace zstrip::scenes {
namespace {

struct Vector {
  double x, y, z;
};
constexpr Vector operator*(double factor, const Vector& v) { return {factor * v.x, factor * v.y, factor * v.z}; }
constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Circle {
  Vector centre, across, up;  ///< the last two are perpendicular, with the length of the radius
};

consteval Circle circle(std::size_t wire) {
  if (wire < kWireMeridians) {
    const double longitude = compile_time::kPi * static_cast<double>(wire) / kWireMeridians;
    return {{0, 0, 0}, {compile_time::cosine(longitude), 0, compile_time::sine(longitude)}, {0, 1, 0}};
  }
  const double latitude = compile_time::kPi / 4 * (static_cast<double>(wire - kWireMeridians) - 1);
  const double radius = compile_time::cosine(latitude);
  return {{0, compile_time::sine(latitude), 0}, {radius, 0, 0}, {0, 0, radius}};
}

struct Vertex {
  Vector position, normal;
};

consteval std::array<Vertex, kWiresVertices> vertices() {
  using compile_time::cosine, compile_time::sine;
  std::array<Vertex, kWiresVertices> result{};
  std::size_t next = 0;
  for (std::size_t wire = 0; wire < kWireMeridians + kWireParallels; ++wire) {
    const Circle c = circle(wire);
    const double radius2 = c.across.x * c.across.x + c.across.y * c.across.y + c.across.z * c.across.z;
    const double radius = compile_time::square_root(radius2);
    const Vector axis = (1 / radius2) * cross(c.across, c.up);
    for (std::size_t i = 0; i < kWireSegments; ++i) {
      const double turn = 2 * compile_time::kPi * static_cast<double>(i) / kWireSegments;
      const Vector out = cosine(turn) * c.across + sine(turn) * c.up;
      for (std::size_t side = 0; side < kWireSides; ++side) {
        const double angle = 2 * compile_time::kPi * static_cast<double>(side) / kWireSides;
        const Vector normal = (cosine(angle) / radius) * out + sine(angle) * axis;
        result[next++] = {c.centre + out + kWireRadius * normal, normal};
      }
    }
  }
  return result;
}

constexpr auto kShape = vertices();

consteval std::array<Position, kWiresVertices> positions() {
  const auto on_grid = [](double value) consteval {
    return compile_time::grid_step(compile_time::nearest(value * 32767 / (1 + kWireRadius)));
  };
  std::array<Position, kWiresVertices> result{};
  for (std::size_t i = 0; i < kWiresVertices; ++i) {
    const Vector& p = kShape[i].position;
    result[i] = {on_grid(p.x), on_grid(p.y), on_grid(p.z)};
  }
  return result;
}

consteval std::array<Normal, kWiresVertices> normals() {
  const auto quantised = [](double value) consteval {
    return static_cast<std::int8_t>(compile_time::nearest(127 * value));  // 1.7
  };
  std::array<Normal, kWiresVertices> result{};
  for (std::size_t i = 0; i < kWiresVertices; ++i) {
    const Vector& n = kShape[i].normal;
    result[i] = {quantised(n.x), quantised(n.y), quantised(n.z), 0};
  }
  return result;
}

consteval std::array<Triangle, 2 * kWiresVertices> closed_prisms() {
  std::array<Triangle, 2 * kWiresVertices> result{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < kWiresVertices / kWireSides; ++i) {
    const std::size_t wire = i / kWireSegments, following = wire * kWireSegments + (i + 1) % kWireSegments;
    for (std::size_t side = 0; side < kWireSides; ++side) {
      const auto index = [](std::size_t segment, std::size_t s) {
        return static_cast<std::uint16_t>(segment * kWireSides + s % kWireSides);
      };
      const std::uint16_t a = index(i, side), b = index(following, side), c = index(following, side + 1),
                          d = index(i, side + 1);
      result[next++] = {a, b, c};
      result[next++] = {a, c, d};
    }
  }
  return result;
}

}  // namespace

constexpr std::array<Position, kWiresVertices> kWiresPositions = positions();
constexpr std::array<Normal, kWiresVertices> kWiresNormals = normals();
constexpr std::array<Triangle, 2 * kWiresVertices> kWiresTriangles = closed_prisms();

static_assert(validate(wires.scene));

}  // namespace zstrip::scenes
