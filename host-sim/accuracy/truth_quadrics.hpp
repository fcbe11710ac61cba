// The visible point of a sphere or ellipsoid on a ray, in double precision.
#pragma once

#include <optional>

#include "accuracy/truth_light.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim::truth {

struct QuadricSample {
  double w = 0;         ///< distance along the viewing direction
  double u = 0, v = 0;  ///< texels of its texture
  Vector rgb{};         ///< 0..255, without fog
};

/// One quadric of a scene, seen by a camera. Holds views of the scene.
class QuadricTruth {
 public:
  QuadricTruth(const Scene& scene, const Quadric& quadric, const Camera& camera);

  /// Returns the sample on the ray through a position in the picture, in picture heights from its middle, y upwards:
  /// the surface between near and far plane. A double-sided quadric shows its inner side where the outer side is
  /// clipped.
  std::optional<QuadricSample> at(double x, double y) const;

 private:
  Vector to_sphere(const Vector& v) const;
  std::optional<QuadricSample> sample(const Vector& origin, const Vector& direction, double w) const;

  const Scene& scene_;
  const Material& material_;
  Vector rows_[3];  ///< rows of the inverse of the sphere's axes
  Vector centre_, eye_, right_, up_, back_;
  double focal_, near_, far_;
  bool orthographic_;
};

}  // namespace zstrip::sim::truth
