// From camera options, in the model's own units, to the renderer's camera.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "import/model.hpp"
#include "render/framing.hpp"
#include "result.hpp"
#include "zstrip/camera.hpp"

namespace zstrip::sim {

inline constexpr double kDefaultFieldOfView = 30;  ///< degrees, vertical

struct Orbit {
  double radius = 1;  ///< the model's units, > 0
  double phi = 0;     ///< degrees
  double theta = 90;  ///< degrees
};

/// Lengths in the model's units. At most one of `name`, `eye` and `orbit`; `name` alone.
struct CameraOptions {
  std::optional<std::string> name{};  ///< of a camera of the model's file
  std::optional<std::array<double, 3>> eye{};
  std::optional<Orbit> orbit{};
  std::optional<std::array<double, 3>> look_at{};  ///< empty: the scene's origin, the centre of a model
  std::optional<double> field_of_view{};           ///< degrees, 1..170
  bool orthographic = false;

  bool placed() const { return eye.has_value() || orbit.has_value(); }
};

/// A camera at the place that the options name. An orthographic one shows at the target what the field of view would.
/// `radius`: of the scene about its origin, for the near and far planes.
Result<Camera> place_camera(const CameraOptions& options, const Units& units, double radius);

/// A camera of the file. In pictures of any shape it shows as much from top to bottom.
Result<Camera> file_camera(const SourceCamera& source, const Units& units, double radius);

/// A camera with this `framing`, tilted by kTilt.
Result<Camera> framed_camera(const CameraOptions& options, const Framing& framing, double radius);

/// In the scene's units.
double distance_to_origin(const Camera& camera);

/// Gives a perspective camera the field of view of the options, or else the default.
Result<Done> set_focal(Camera& camera, const CameraOptions& options);

/// A scene's own camera with the field of view and projection of the options; it stays where it is.
Result<Camera> change_projection(Camera camera, const CameraOptions& options);

/// Turns a perspective camera into an orthographic one that shows the same at this distance (scene units) from the eye.
Result<Done> make_orthographic(Camera& camera, double distance);

}  // namespace zstrip::sim
