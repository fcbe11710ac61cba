// The judge of visibility: finds the nearest surface of each pixel in double precision, from the scene's definitions
// only. Edge functions in homogeneous coordinates (Olano and Greer, 1997), without clipping or snapping; shares no
// arithmetic with the renderer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// The distance that a correct picture may have from the exact one.
struct Tolerance {
  double pixels = 1.0 / 16;  ///< for an edge: vertices are snapped
  double nearness = 0;       ///< 1 / distance; with an orthographic camera the distance
};

/// Returns the nearness of one depth code of z16, if codes span distances near..far.
double nearness_of_code(const Camera& camera, Fixed near, Fixed far);

class SurfaceJudge {
 public:
  /// Triangles are counted over all instances, as in NumberedScene.
  SurfaceJudge(const Scene& scene, const Camera& camera, const View& view);

  /// Finds the nearest surface of each pixel, with this tolerance for its place.
  void find_nearest(const Tolerance& tolerance);

  static constexpr std::size_t kBackground = SIZE_MAX;
  /// True if `triangle`, or the background, may be visible at a pixel: it covers the pixel, and no surface that
  /// certainly covers the pixel is nearer. To be called after find_nearest.
  bool may_be_seen(std::size_t triangle, int column, int row) const;
  /// True if a surface certainly covers the pixel.
  bool is_covered(int column, int row) const { return nearest_[at(column, row)] > kNothing; }

 private:
  static constexpr double kNothing = -1e300;
  struct Line {
    double x, y, c;
    double at(double px, double py) const { return x * px + y * py + c; }
  };
  struct Surface {
    bool visible = false;                          ///< faces the viewer and has an area
    std::array<Line, 3> edges;                     ///< positive inside; the weights of the corners
    Line nearness{};                               ///< linear over the picture
    double near = 0, far = 0;                      ///< nearness at the planes of the camera
    int left = 0, top = 0, right = 0, bottom = 0;  ///< the pixels that it may cover
  };
  enum class Cover : std::uint8_t { none, unsure, sure };

  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * view_.width + static_cast<std::size_t>(column);
  }
  Cover covers(const Surface& surface, int column, int row) const;
  double slack(const Surface& surface) const;

  View view_;
  Tolerance tolerance_;
  std::vector<Surface> surfaces_;
  std::vector<double> nearest_;  ///< of each pixel, minus the tolerance of its surface
};

/// Returns one byte for each pixel of a picture of the NumberedScene: 1 if it is wrong, else 0.
std::vector<std::uint8_t> wrong_pixels(const SurfaceJudge& judge, std::span<const std::uint16_t> picture,
                                       const View& view);

}  // namespace zstrip::sim
