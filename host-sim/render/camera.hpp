// Converts camera options, in the model's own units, to the renderer's camera.
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

/// Lengths are in the model's units. At most one of `name`, `eye` and `orbit`; `name` excludes all other members.
struct CameraOptions {
  std::optional<std::string> name{};  ///< of a camera of the model's file
  std::optional<std::array<double, 3>> eye{};
  std::optional<Orbit> orbit{};
  std::optional<std::array<double, 3>> look_at{};  ///< empty: the scene's origin, the centre of a model
  std::optional<double> field_of_view{};           ///< degrees, 1..170
  bool orthographic = false;

  bool placed() const { return eye.has_value() || orbit.has_value(); }
};

/// Places a camera as the options say. An orthographic camera shows at the target the same height as the field of view
/// would. `radius`: of the scene about its origin, for the near and far planes.
Result<Camera> place_camera(const CameraOptions& options, const Units& units, double radius);

/// Converts a camera of the file. In pictures of any shape it shows the same height.
Result<Camera> file_camera(const SourceCamera& source, const Units& units, double radius);

/// Returns a camera with this `framing`, tilted by kTilt.
Result<Camera> framed_camera(const CameraOptions& options, const Framing& framing, double radius);

/// Returns a distance in the scene's units.
double distance_to_origin(const Camera& camera);

/// Sets a perspective camera to the field of view of the options, or else to the default.
Result<Done> set_focal(Camera& camera, const CameraOptions& options);

/// Returns a scene's own camera with the field of view and projection of the options; its position does not change.
Result<Camera> change_projection(Camera camera, const CameraOptions& options);

/// Changes a perspective camera to an orthographic one that shows the same at this distance (scene units) from the eye.
Result<Done> make_orthographic(Camera& camera, double distance);

}  // namespace zstrip::sim
