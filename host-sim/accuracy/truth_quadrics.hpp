// What a ray sees of a sphere or ellipsoid, in double precision.
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

/// One quadric of a scene before a camera; views of the scene.
class QuadricTruth {
 public:
  QuadricTruth(const Scene& scene, const Quadric& quadric, const Camera& camera);

  /// Along the ray through a place in the picture, in picture heights from its middle, y upwards: what lies between
  /// near and far plane; of a double-sided one the inner side, where the outer is cut away.
  std::optional<QuadricSample> at(double x, double y) const;

 private:
  Vector to_sphere(const Vector& v) const;
  std::optional<QuadricSample> sample(const Vector& origin, const Vector& direction, double w) const;

  const Scene& scene_;
  const Material& material_;
  Vector rows_[3];  ///< of the inverse of the sphere's axes
  Vector centre_, eye_, right_, up_, back_;
  double focal_, near_, far_;
  bool orthographic_;
};

}  // namespace zstrip::sim::truth
