// An instance prepared for one frame: forms that convert object-space positions to picture coordinates in a few
// multiplications, and its lights in object space.
#pragma once

#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/geometry/depth_fit.hpp"
#include "zstrip/plan/record_bytes.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// An affine form of a position, offset + x*px + y*py + z*pz, whose value over the whole mesh stays below 2^30.
/// Each product is floor(coefficient * p / 2^16): the upper word of a 32-bit multiplication (SMULL, SMLAWB), so that
/// every target gets the same bits.
struct LinearForm {
  std::int32_t x, y, z, offset;

  constexpr std::int32_t at(const Position& p) const {
    return offset + multiply_by_half(x, p.x) + multiply_by_half(y, p.y) + multiply_by_half(z, p.z);
  }
};

/// The way in which light and material shade this instance; chosen once a frame, not once a triangle. If fragments have
/// effects, `fragments` is added to one of the other values (see fill_fragments); if they are also lit,
/// `lit_fragments`, which includes it, is added instead.
enum class Shade : std::uint8_t {
  flat,
  gouraud,
  textured,
  textured_flat,
  textured_gouraud,
  fragments = 8,
  lit_fragments = 24,
};

constexpr Shade with_fragments(Shade shade) {
  return static_cast<Shade>(static_cast<std::uint8_t>(shade) | static_cast<std::uint8_t>(Shade::fragments));
}
constexpr Shade with_lit_fragments(Shade shade) {
  return static_cast<Shade>(static_cast<std::uint8_t>(shade) | static_cast<std::uint8_t>(Shade::lit_fragments));
}
constexpr bool has_lit_fragments(Shade shade) { return shade >= with_lit_fragments(Shade{}); }
constexpr Shade without_fragments(Shade shade) {
  return static_cast<Shade>(static_cast<std::uint8_t>(shade) & ~static_cast<std::uint8_t>(Shade::lit_fragments));
}

struct ObjectLight {
  std::int16_t x, y, z;          ///< 1.15, unit vector towards the light, in object space
  std::uint8_t r, g, b, unused;  ///< light times material
};

struct CompiledInstance {
  LinearForm x, y;                ///< numerators of the picture coordinates
  LinearForm w;                   ///< distance along the viewing direction, in the instance's own scale
  std::int32_t shift_x, shift_y;  ///< x/w in 1/16 pixels = x * reciprocal(w normalised by n) >> (32 + shift - n)
  std::uint32_t w_near, w_range;  ///< w - w_near <= w_range (unsigned) is inside the depth range
  std::uint32_t depth_scale;
  std::uint8_t depth_shift;          ///< left shift after the scale
  std::uint8_t depth_normalisation;  ///< perspective: leading zeros of w_near; orthographic: left shift of w_far - w
  Shade shade;
  std::uint8_t light_count;
  ObjectLight lights[kMaxLights];
  Colour ambient;  ///< ambient light times material
  Colour base;     ///< colour of the material
  std::uint16_t mesh, material;
  bool lit, coloured, double_sided, visible;
};
static_assert(sizeof(CompiledInstance) <= kInstanceBytes);

/// The distances that the instance's bounding box spans along the viewing direction. They may be behind the camera.
struct DistanceRange {
  Distance nearest, farthest;
};
DistanceRange distance_range(const Mesh& mesh, const Transform& transform, const Camera& camera);

inline constexpr DistanceRange kNoReach{INT64_MAX, INT64_MIN};

/// Extends `reach` by `range`, if `range` overlaps the camera's depth range.
constexpr void extend(DistanceRange& reach, const DistanceRange& range, const Camera& camera) {
  if (range.farthest < distance_of(camera.near_plane) || range.nearest > distance_of(camera.far_plane)) return;
  if (range.nearest < reach.nearest) reach.nearest = range.nearest;
  if (range.farthest > reach.farthest) reach.farthest = range.farthest;
}

/// Returns Error::instance if the instance's picture would be more than 2^26 pixels wide, or if its box is so much
/// larger than the frame's depth range that the range would be one step of w. `view` has pixels. `orthographic`: the
/// camera's projection; `lights`: anything may be lit.
template <bool orthographic, bool lights>
Status compile_instance(CompiledInstance& compiled, const Scene& scene, const Instance& instance, const Camera& camera,
                        const View& view, const DepthFit& fit);
inline Status compile_instance(CompiledInstance& compiled, const Scene& scene, const Instance& instance,
                               const Camera& camera, const View& view, const DepthFit& fit) {
  return camera.projection == Projection::orthographic
             ? compile_instance<true, true>(compiled, scene, instance, camera, view, fit)
             : compile_instance<false, true>(compiled, scene, instance, camera, view, fit);
}

}  // namespace zstrip::detail
