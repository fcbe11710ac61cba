// The four planes around a pixel: they tell which meshlets cannot cover it, by their spheres and without a division.
#pragma once

#include <cstdint>

#include "zstrip/geometry/project.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Planes through the eye and the sides of a pixel that is a pixel larger on each side, in the space of an instance.
class PixelPlanes {
 public:
  /// `pixel`: a rectangle of raster pixels. `mesh`: the instance's.
  PixelPlanes(const CompiledInstance& instance, const Mesh& mesh, const RasterOrigin& origin, const Rect& pixel,
              bool orthographic);
  /// True if no part of the sphere is between the planes: no triangle of the meshlet covers the pixel. `instance`: that
  /// of the constructor.
  bool miss(const CompiledInstance& instance, const Meshlet& meshlet) const;

 private:
  /// The values of a plane's form x * 2^exponent - at * w are negative on its left.
  struct Plane {
    std::int32_t at;      ///< 1/16 pixels
    std::uint32_t reach;  ///< what a sphere adds to the value at its centre: radius * reach * 2^shift
    std::int32_t shift;
  };
  Plane plane_of(const LinearForm& form, int exponent, std::int32_t at, const std::uint64_t (&ratios)[3]) const;
  bool misses(const Plane& low, const Plane& high, std::int32_t numerator, std::int32_t w, int exponent,
              std::uint16_t radius) const;

  LinearForm w_;
  int exponent_x_, exponent_y_;
  Plane left_, right_, top_, bottom_;
};

}  // namespace zstrip::detail
