// Converts camera options, in the model's own units, to the renderer's camera.
#include "render/camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "import/quantise.hpp"

namespace zstrip::sim {
namespace {

/// Larger coordinates leave no room for the far plane in 16.16.
constexpr double kFarthest = 10000;

/// The largest number in 16.16.
constexpr double kMaxLength = 32767;

Failure out_of_range(const char* option) {
  return {ExitStatus::usage, std::string(option) + " is too far away: more than 10000 times the size of the model"};
}

Angle to_angle(double degrees) {
  return static_cast<Angle>(std::llround(std::remainder(degrees, 360) / 360 * kFullTurn));
}

std::array<double, 3> to_scene(const std::array<double, 3>& point, const Units& units) {
  std::array<double, 3> scene{};
  for (std::size_t axis = 0; axis < 3; ++axis) scene[axis] = (point[axis] - units.origin[axis]) * units.scale;
  return scene;
}

bool in_range(const std::array<double, 3>& point) {
  return std::all_of(point.begin(), point.end(), [](double c) { return std::abs(c) <= kFarthest; });
}

Vec3 to_fixed(const std::array<double, 3>& point) {
  return {sim::to_fixed(point[0]), sim::to_fixed(point[1]), sim::to_fixed(point[2])};
}

/// Sets near and far plane around everything that can be in front of the eye; the renderer fits the depth range inside.
/// Inside of the scene the near plane is at 0.01, or nearer at `nearest` (scene units).
void set_planes(Camera& camera, double radius, double nearest = 0.01) {
  constexpr double kMinNear = 1.0 / 8192;
  const double distance = distance_to_origin(camera);
  camera.near_plane = sim::to_fixed(std::max(0.9 * (distance - radius), std::clamp(nearest, kMinNear, 0.01)));
  camera.far_plane = sim::to_fixed(std::min(1.1 * (distance + radius) + 0.1, kMaxLength));
}

}  // namespace

Result<Done> set_focal(Camera& camera, const CameraOptions& options) {
  const double degrees = options.field_of_view.value_or(kDefaultFieldOfView);
  if (!set_field_of_view(camera, to_angle(degrees)))
    return Failure{ExitStatus::usage, "--fov must be 1 to 170 degrees"};
  return Done{};
}

double distance_to_origin(const Camera& camera) {
  return std::hypot(from_fixed(camera.eye.x), from_fixed(camera.eye.y), from_fixed(camera.eye.z));
}

Result<Done> make_orthographic(Camera& camera, double distance) {
  camera.projection = Projection::orthographic;
  const double focal = static_cast<double>(camera.focal) / distance;  // 16.16
  if (focal < 1 || focal > 0x7FFFFFFF) return Failure{ExitStatus::usage, "--ortho: the camera is too near or too far"};
  camera.focal = static_cast<Fixed>(std::llround(focal));
  return Done{};
}

Result<Camera> change_projection(Camera camera, const CameraOptions& options) {
  if (options.field_of_view) {
    if (camera.projection == Projection::orthographic) {
      return Failure{ExitStatus::usage,
                     "--fov: the scene's own camera is a parallel one; place another with --eye or --orbit"};
    }
    if (const Result<Done> changed = set_focal(camera, options); !changed) return changed.failure();
  }
  if (options.orthographic && camera.projection != Projection::orthographic) {
    const Result<Done> changed = make_orthographic(camera, distance_to_origin(camera));
    if (!changed) return changed.failure();
  }
  return camera;
}

Result<Camera> place_camera(const CameraOptions& options, const Units& units, double radius) {
  const std::array<double, 3> target = options.look_at ? to_scene(*options.look_at, units) : std::array<double, 3>{};
  if (!in_range(target)) return out_of_range("--look-at");
  Camera camera;
  double distance = 0;
  if (options.eye) {
    const std::array<double, 3> eye = to_scene(*options.eye, units);
    if (!in_range(eye)) return out_of_range("--eye");
    distance = std::hypot(eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]);
    if (!look_at(camera, to_fixed(eye), to_fixed(target), {0, kFixedOne, 0})) {
      return Failure{ExitStatus::usage,
                     "--eye is the point that the camera looks at; move it, or give another --look-at"};
    }
  } else {
    distance = options.orbit->radius * units.scale;
    if (distance > kFarthest) return out_of_range("--orbit");
    if (!orbit(camera, to_fixed(target), sim::to_fixed(distance), to_angle(options.orbit->phi),
               to_angle(options.orbit->theta))) {
      return Failure{ExitStatus::usage,
                     "--orbit: the radius must be greater than 0, and not tiny compared with the model"};
    }
  }
  if (const Result<Done> focal = set_focal(camera, options); !focal) return focal.failure();
  if (options.orthographic) {
    if (const Result<Done> changed = make_orthographic(camera, distance); !changed) return changed.failure();
  }
  // A camera close to a large ground looks at something close.
  set_planes(camera, radius, 0.05 * distance);
  return camera;
}

Result<Camera> file_camera(const SourceCamera& source, const Units& units, double radius) {
  const auto unusable = [&source](const char* what) {
    return Failure{ExitStatus::input, fmt::format("the camera '{}' {}", source.name, what)};
  };
  const std::array<double, 3> eye = to_scene(source.eye, units);
  if (!in_range(eye)) return unusable("is too far away: more than 10000 times the size of the model");
  constexpr double kAhead = 64;  // long enough for the direction's precision, short enough for 16.16
  std::array<double, 3> target = eye;
  for (std::size_t axis = 0; axis < 3; ++axis) target[axis] += kAhead * source.towards[axis];
  Camera camera;
  if (!look_at(camera, to_fixed(eye), to_fixed(target), to_fixed(source.up))) return unusable("has no direction");
  if (source.orthographic) {
    camera.projection = Projection::orthographic;
    const double focal = 1 / (source.half_height * units.scale);
    if (!(focal > 1.0 / kFixedOne && focal < kMaxLength)) return unusable("shows too much or too little");
    camera.focal = sim::to_fixed(focal);
  } else if (!(source.field_of_view >= 1 && source.field_of_view <= 170)) {
    return unusable("has a field of view outside 1 to 170 degrees");
  } else if (const Result<Done> focal = set_focal(camera, {.field_of_view = source.field_of_view}); !focal) {
    return focal.failure();
  }
  set_planes(camera, radius, source.near > 0 ? source.near * units.scale : 0.01);
  return camera;
}

Result<Camera> framed_camera(const CameraOptions& options, const Framing& framing, double radius) {
  Camera camera;
  if (!orbit(camera, to_fixed(framing.target), sim::to_fixed(framing.distance), to_angle(framing.yaw),
             to_angle(90 - kTilt))) {
    return Failure{ExitStatus::internal, "cannot place the camera"};
  }
  if (const Result<Done> focal = set_focal(camera, options); !focal) return focal.failure();
  if (options.orthographic) {
    camera.projection = Projection::orthographic;
    camera.focal = sim::to_fixed(1 / framing.half_height);
  }
  set_planes(camera, radius);
  return camera;
}

}  // namespace zstrip::sim
