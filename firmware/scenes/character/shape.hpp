// The character's surface, computed at compile time: eight closed tubes around a skeleton. A tube is a row of ellipses
// with half an ellipsoid at either end, cut into patches of 8 sides; each patch is a meshlet.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/compile_time.hpp"

namespace zstrip::scenes::character_shape {

/// A vector in world units. The figure stands upright and looks at +z, its left is +x, and the origin is in its middle.
struct Vector {
  double x, y, z;
};

constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
consteval Vector unit(const Vector& v) {
  const double length = compile_time::square_root(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

/// The height of the middle above the ground.
inline constexpr double kMiddle = 0.92;

enum JointName : std::uint8_t {
  kPelvis,
  kSpine,
  kChest,
  kNeck,
  kHead,
  kLeftArm,
  kLeftForearm,
  kLeftHand,
  kRightArm,
  kRightForearm,
  kRightHand,
  kLeftThigh,
  kLeftShin,
  kLeftFoot,
  kLeftToes,
  kRightThigh,
  kRightShin,
  kRightFoot,
  kRightToes,
};
static_assert(kRightToes + 1 == kCharacterJoints);

struct JointPlace {
  std::uint16_t parent;
  Vector place;  ///< relative to the ground
};
inline constexpr JointPlace kJointPlaces[kCharacterJoints] = {{kNoJoint, {0, 0.95, 0}},
                                                              {kPelvis, {0, 1.08, 0}},
                                                              {kSpine, {0, 1.25, 0}},
                                                              {kChest, {0, 1.48, 0}},
                                                              {kNeck, {0, 1.57, 0.01}},
                                                              {kChest, {0.235, 1.42, 0}},
                                                              {kLeftArm, {0.275, 1.15, 0}},
                                                              {kLeftForearm, {0.305, 0.91, 0}},
                                                              {kChest, {-0.235, 1.42, 0}},
                                                              {kRightArm, {-0.275, 1.15, 0}},
                                                              {kRightForearm, {-0.305, 0.91, 0}},
                                                              {kPelvis, {0.1, 0.92, 0}},
                                                              {kLeftThigh, {0.105, 0.5, 0.01}},
                                                              {kLeftShin, {0.11, 0.09, -0.01}},
                                                              {kLeftFoot, {0.115, 0.04, 0.13}},
                                                              {kPelvis, {-0.1, 0.92, 0}},
                                                              {kRightThigh, {-0.105, 0.5, 0.01}},
                                                              {kRightShin, {-0.11, 0.09, -0.01}},
                                                              {kRightFoot, {-0.115, 0.04, 0.13}}};

/// An ellipse across a tube. For upright tubes `at` is a height, `aside` a z and `half_aside` is along z; for a tube
/// along z, height and z are exchanged.
struct Ellipse {
  double at, x, aside, half_x, half_aside;
};
/// The range in which vertices pass from one joint to the next: from `at` - `reach` to `at` + `reach`.
struct Bend {
  double at, reach;
  std::uint8_t to;
};
/// A part of the texture for a whole tube: texels to the right and down.
struct TexelArea {
  double left, top, width, height;
};

/// A tube. Rings have the numbers 0 .. sum of `patch_rings`; the first and the last are poles.
struct Tube {
  bool upright;
  bool mirrored;  ///< x is negated
  std::size_t sides;
  std::span<const std::size_t> patch_rings;
  std::span<const Ellipse> ellipses;
  double first_cap, last_cap;  ///< lengths of its ends
  std::uint8_t joint;          ///< joint of its first ring
  std::span<const Bend> bends;
  TexelArea texels;

  constexpr std::size_t rings() const {
    std::size_t sum = 0;
    for (const std::size_t rings : patch_rings) sum += rings;
    return sum;
  }
  constexpr std::size_t patches_around() const { return sides / kCharacterPatchSides; }
};

inline constexpr std::size_t kTrunkPatches[] = {6, 5, 5, 5}, kArmPatches[] = {6, 6, 6}, kLegPatches[] = {6, 6, 5},
                             kFootPatches[] = {6, 5};
inline constexpr Ellipse kTorso[] = {{0.80, 0, 0, 0.148, 0.106}, {0.92, 0, -0.01, 0.196, 0.138},
                                     {1.08, 0, 0, 0.164, 0.117}, {1.25, 0, 0.01, 0.207, 0.138},
                                     {1.42, 0, 0, 0.228, 0.117}, {1.53, 0, 0, 0.138, 0.0901}};
inline constexpr Ellipse kNeckAndHead[] = {{1.42, 0, 0, 0.0735, 0.0735},    {1.53, 0, 0.005, 0.063, 0.0651},
                                           {1.58, 0, 0.03, 0.0893, 0.0945}, {1.68, 0, 0.015, 0.124, 0.137},
                                           {1.78, 0, 0.005, 0.126, 0.142},  {1.86, 0, 0, 0.105, 0.121}};
inline constexpr Ellipse kArm[] = {{0.72, 0.315, 0.015, 0.0286, 0.0495}, {0.84, 0.31, 0.01, 0.0374, 0.0616},
                                   {0.92, 0.305, 0, 0.0396, 0.044},      {1.06, 0.285, 0, 0.055, 0.0583},
                                   {1.15, 0.275, 0, 0.0528, 0.055},      {1.30, 0.252, 0, 0.0682, 0.0726},
                                   {1.48, 0.225, 0, 0.0814, 0.0814}};
inline constexpr Ellipse kLeg[] = {{0.03, 0.11, -0.01, 0.056, 0.0616},   {0.12, 0.11, -0.01, 0.0582, 0.0627},
                                   {0.34, 0.108, -0.01, 0.0784, 0.0862}, {0.50, 0.105, 0.01, 0.0806, 0.0851},
                                   {0.72, 0.102, 0.005, 0.105, 0.112},   {0.98, 0.095, 0, 0.112, 0.129}};
inline constexpr Ellipse kFoot[] = {{-0.09, 0.11, 0.05, 0.0528, 0.055},
                                    {0.0, 0.112, 0.052, 0.0572, 0.0616},
                                    {0.12, 0.115, 0.04, 0.066, 0.0462},
                                    {0.23, 0.12, 0.035, 0.055, 0.0374}};
inline constexpr Bend kTorsoBends[] = {{1.06, 0.07, kSpine}, {1.22, 0.08, kChest}};
inline constexpr Bend kHeadBends[] = {{1.48, 0.035, kNeck}, {1.555, 0.035, kHead}};
inline constexpr Bend kLeftArmBends[] = {{0.91, 0.035, kLeftForearm}, {1.15, 0.06, kLeftArm}};
inline constexpr Bend kRightArmBends[] = {{0.91, 0.035, kRightForearm}, {1.15, 0.06, kRightArm}};
inline constexpr Bend kLeftLegBends[] = {{0.10, 0.05, kLeftShin}, {0.50, 0.09, kLeftThigh}};
inline constexpr Bend kRightLegBends[] = {{0.10, 0.05, kRightShin}, {0.50, 0.09, kRightThigh}};
inline constexpr Bend kLeftFootBends[] = {{0.13, 0.04, kLeftToes}};
inline constexpr Bend kRightFootBends[] = {{0.13, 0.04, kRightToes}};

// The areas that texture.hpp paints.
inline constexpr TexelArea kShirtTexels{0, 0, 32, 32}, kHeadTexels{32, 0, 32, 32}, kArmTexels{0, 32, 32, 32},
    kLegTexels{32, 32, 32, 24}, kShoeTexels{32, 56, 32, 8};

inline constexpr Tube kTubes[] = {
    {true, false, 24, kTrunkPatches, kTorso, 0.08, 0.09, kPelvis, kTorsoBends, kShirtTexels},
    {true, false, 24, kTrunkPatches, kNeckAndHead, 0.02, 0.10, kChest, kHeadBends, kHeadTexels},
    {true, false, 16, kArmPatches, kArm, 0.05, 0.07, kLeftHand, kLeftArmBends, kArmTexels},
    {true, true, 16, kArmPatches, kArm, 0.05, 0.07, kRightHand, kRightArmBends, kArmTexels},
    {true, false, 16, kLegPatches, kLeg, 0.04, 0.09, kLeftFoot, kLeftLegBends, kLegTexels},
    {true, true, 16, kLegPatches, kLeg, 0.04, 0.09, kRightFoot, kRightLegBends, kLegTexels},
    {false, false, 16, kFootPatches, kFoot, 0.05, 0.07, kLeftFoot, kLeftFootBends, kShoeTexels},
    {false, true, 16, kFootPatches, kFoot, 0.05, 0.07, kRightFoot, kRightFootBends, kShoeTexels}};

/// Interpolates between neighbouring ellipses with cubics, whose slopes are those from neighbour to neighbour.
constexpr Ellipse ellipse_at(std::span<const Ellipse> ellipses, double at) {
  std::size_t i = 0;
  while (i + 2 < ellipses.size() && ellipses[i + 1].at < at) ++i;
  const Ellipse &a = ellipses[i], &b = ellipses[i + 1];
  const Ellipse& before = ellipses[i == 0 ? 0 : i - 1];
  const Ellipse& after = ellipses[i + 2 < ellipses.size() ? i + 2 : i + 1];
  const double length = b.at - a.at, t = (at - a.at) / length;
  const auto between = [&](double Ellipse::*value) {
    const double slope_a = (b.*value - before.*value) / (b.at - before.at) * length;
    const double slope_b = (after.*value - a.*value) / (after.at - a.at) * length;
    const double h = t * t * (3 - 2 * t);
    return a.*value * (1 - h) + b.*value * h + slope_a * t * (1 - t) * (1 - t) - slope_b * t * t * (1 - t);
  };
  return {at, between(&Ellipse::x), between(&Ellipse::aside), between(&Ellipse::half_x), between(&Ellipse::half_aside)};
}

/// The place of a ring, and its size relative to its ellipse: rings of the ends are those of a sphere, at equal angles.
struct Ring {
  double at, size;
};
consteval Ring ring_of(const Tube& tube, std::size_t ring) {
  constexpr std::size_t kCapRings = 3;
  const double first = tube.ellipses.front().at, last = tube.ellipses.back().at;
  const auto angle = [](std::size_t i) { return compile_time::kPi / 2 * static_cast<double>(i) / kCapRings; };
  if (ring < kCapRings) {
    return {first + tube.first_cap * (1 - compile_time::cosine(angle(ring))), compile_time::sine(angle(ring))};
  }
  const std::size_t to_end = tube.rings() - ring;
  if (to_end < kCapRings) {
    return {last - tube.last_cap * (1 - compile_time::cosine(angle(to_end))), compile_time::sine(angle(to_end))};
  }
  const double low = first + tube.first_cap, high = last - tube.last_cap;
  const auto steps = static_cast<double>(tube.rings() - 2 * kCapRings);
  return {low + (high - low) * static_cast<double>(ring - kCapRings) / steps, 1};
}

/// A vertex before it is quantised.
struct Vertex {
  Vector position;
  Vector normal;
  VertexJoints joints;
  double u, v;  ///< texels
};

struct Direction {
  double sine, cosine;
};
/// Returns a direction around a tube, beginning at the back (for a foot, below) by way of x; directions are closer
/// together in front.
consteval Direction direction(std::size_t side, std::size_t sides) {
  const double whole = 2 * compile_time::kPi * static_cast<double>(side % sides) / static_cast<double>(sides);
  const double angle = whole + 0.45 * compile_time::sine(whole);
  return {compile_time::sine(angle), compile_time::cosine(angle)};
}

constexpr Vector point(const Tube& tube, const Ellipse& ellipse, double size, const Direction& direction) {
  const double x = tube.mirrored ? -ellipse.x : ellipse.x;
  const double across = ellipse.half_x * size * direction.sine;
  const double aside = ellipse.aside - ellipse.half_aside * size * direction.cosine;
  return tube.upright ? Vector{x + across, ellipse.at - kMiddle, aside}
                      : Vector{x - across, aside - kMiddle, ellipse.at};
}

consteval VertexJoints joints_at(const Tube& tube, double at) {
  std::uint8_t joint = tube.joint;
  for (const Bend& bend : tube.bends) {
    const double share = (at - bend.at + bend.reach) / (2 * bend.reach);
    if (share <= 0) break;
    if (share < 1) {
      const auto weight = static_cast<std::uint8_t>(compile_time::nearest(256 * share * share * (3 - 2 * share)));
      if (weight == 0) break;
      if (weight < 128) return {{joint, bend.to}, {static_cast<std::uint8_t>(255 - weight), weight}};
      const auto rest = static_cast<std::uint8_t>(255 - (weight < 255 ? weight : 255));
      return {{bend.to, rest == 0 ? std::uint8_t{0} : joint}, {static_cast<std::uint8_t>(255 - rest), rest}};
    }
    joint = bend.to;
  }
  return {{joint}, {255}};
}

constexpr std::size_t vertices_of(const Tube& tube) {
  std::size_t count = 0;
  for (const std::size_t rings : tube.patch_rings) count += (rings + 1) * (kCharacterPatchSides + 1);
  return count * tube.patches_around();
}
constexpr std::size_t triangles_of(const Tube& tube) { return 2 * tube.sides * (tube.rings() - 1); }

inline constexpr std::size_t kMaxRings = 21, kMaxSides = 24;

/// The whole surface of a tube, ring after ring, with both ends of each ring.
struct Grid {
  std::array<std::array<Vertex, kMaxSides + 1>, kMaxRings + 1> vertices{};
};

consteval Grid grid_of(const Tube& tube) {
  Grid grid;
  std::array<Direction, kMaxSides + 1> directions{};
  for (std::size_t j = 0; j <= tube.sides; ++j) directions[j] = direction(j, tube.sides);
  const std::size_t rings = tube.rings();
  const double first = tube.ellipses.front().at, last = tube.ellipses.back().at;
  for (std::size_t i = 0; i <= rings; ++i) {
    const Ring ring = ring_of(tube, i);
    const Ellipse ellipse = ellipse_at(tube.ellipses, ring.at);
    const double share = (ring.at - first) / (last - first);
    for (std::size_t j = 0; j <= tube.sides; ++j) {
      Vertex& vertex = grid.vertices[i][j];
      vertex.position = point(tube, ellipse, ring.size, directions[j]);
      vertex.joints = joints_at(tube, ring.at);
      vertex.u =
          tube.texels.left + 0.5 + (tube.texels.width - 1) * static_cast<double>(j) / static_cast<double>(tube.sides);
      vertex.v = tube.texels.top + 0.5 + (tube.texels.height - 1) * (1 - share);
    }
  }
  for (std::size_t i = 0; i <= rings; ++i) {
    for (std::size_t j = 0; j <= tube.sides; ++j) {
      if (i == 0 || i == rings) {
        const double axis = i == 0 ? -1 : 1;
        grid.vertices[i][j].normal = tube.upright ? Vector{0, axis, 0} : Vector{0, 0, axis};
        continue;
      }
      const Vector along = grid.vertices[i + 1][j].position - grid.vertices[i - 1][j].position;
      const std::size_t next = j == tube.sides ? 1 : j + 1, before = j == 0 ? tube.sides - 1 : j - 1;
      const Vector around = grid.vertices[i][next].position - grid.vertices[i][before].position;
      grid.vertices[i][j].normal = unit(cross(along, around));
    }
  }
  return grid;
}

/// All tables of the mesh, patch after patch.
struct Cut {
  std::array<Vertex, kCharacterVertices> vertices{};
  std::array<Triangle, kCharacterTriangleCount> triangles{};
  std::array<Meshlet, kCharacterMeshletCount> meshlets{};  ///< without bounding spheres
};

consteval Cut cut() {
  Cut result;
  std::size_t vertices = 0, triangles = 0, meshlets = 0;
  for (const Tube& tube : kTubes) {
    const Grid grid = grid_of(tube);
    const std::size_t all_rings = tube.rings();
    std::size_t first_ring = 0;
    for (const std::size_t rings : tube.patch_rings) {
      for (std::size_t patch = 0; patch < tube.patches_around(); ++patch) {
        Meshlet& meshlet = result.meshlets[meshlets++];
        meshlet.first_triangle = static_cast<std::uint32_t>(triangles);
        meshlet.first_vertex = static_cast<std::uint16_t>(vertices);
        const auto index = [&](std::size_t ring, std::size_t side) {
          return static_cast<std::uint16_t>(meshlet.first_vertex + ring * (kCharacterPatchSides + 1) + side);
        };
        for (std::size_t i = 0; i <= rings; ++i) {
          for (std::size_t j = 0; j <= kCharacterPatchSides; ++j) {
            result.vertices[vertices++] = grid.vertices[first_ring + i][patch * kCharacterPatchSides + j];
          }
        }
        for (std::size_t i = 0; i < rings; ++i) {
          for (std::size_t j = 0; j < kCharacterPatchSides; ++j) {
            const std::uint16_t a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
            if (first_ring + i + 1 != all_rings) result.triangles[triangles++] = {a, b, c};
            if (first_ring + i != 0) result.triangles[triangles++] = {a, c, d};
          }
        }
        meshlet.vertex_count = static_cast<std::uint16_t>(vertices - meshlet.first_vertex);
        meshlet.triangle_count = static_cast<std::uint16_t>(triangles - meshlet.first_triangle);
      }
      first_ring += rings;
    }
  }
  return result;
}

constexpr bool counts_are_right() {
  std::size_t vertices = 0, triangles = 0, meshlets = 0;
  for (const Tube& tube : kTubes) {
    vertices += vertices_of(tube), triangles += triangles_of(tube);
    meshlets += tube.patches_around() * tube.patch_rings.size();
  }
  return vertices == kCharacterVertices && triangles == kCharacterTriangleCount && meshlets == kCharacterMeshletCount;
}
static_assert(counts_are_right());

}  // namespace zstrip::scenes::character_shape
