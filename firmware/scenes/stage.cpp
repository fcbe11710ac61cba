// Places the instances and the camera of one frame: rotations about the axes, in 16.16.
#include "zstrip_scenes/stage.hpp"

#include <algorithm>
#include <iterator>

#include "zstrip/base/math.hpp"

namespace zstrip::scenes {
namespace {

/// 0.1 and 0.05 radians in 0.32 of a full circle, rounded to nearest.
constexpr std::uint32_t kWorkloadStep = 68356528;
constexpr std::uint32_t kWorkloadHalfStep = 34178264;

struct Rotation {
  Fixed sine, cosine;  // 16.16
};

Rotation rotation_by(Angle angle) {
  constexpr int kDropped = 30 - kFixedBits;
  const auto rounded = [](std::int32_t value) { return (value + (1 << (kDropped - 1))) >> kDropped; };  // nearest
  return {rounded(sine(angle)), rounded(cosine(angle))};
}

Angle turn(std::uint32_t frame, std::uint32_t frames) {
  frames = std::max<std::uint32_t>(frames, 1);
  return static_cast<Angle>(std::uint64_t{frame % frames} * kFullTurn / frames);
}

Transform about_x(const Rotation& r) {
  return {{{kFixedOne, 0, 0, 0}, {0, r.cosine, -r.sine, 0}, {0, r.sine, r.cosine, 0}}};
}

Transform about_y(const Rotation& r) {
  return {{{r.cosine, 0, r.sine, 0}, {0, kFixedOne, 0, 0}, {-r.sine, 0, r.cosine, 0}}};
}

/// Returns the transform that applies `first`, then `second`; each product rounds down.
Transform combine(const Transform& second, const Transform& first) {
  Transform result{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      Fixed sum = column == 3 ? second.m[row][3] : 0;
      for (int k = 0; k < 3; ++k) sum += fixed_multiply(second.m[row][k], first.m[k][column]);
      result.m[row][column] = sum;
    }
  }
  return result;
}

/// Also used for the camera's axes: 2.30 by 16.16 is 2.30.
Vec3 turned_about_y(const Vec3& v, const Rotation& r) {
  return {fixed_multiply(v.x, r.cosine) + fixed_multiply(v.z, r.sine), v.y,
          fixed_multiply(v.z, r.cosine) - fixed_multiply(v.x, r.sine)};
}

bool is_near(Fixed coordinate) { return coordinate >= -kFarthestTurned && coordinate <= kFarthestTurned; }

}  // namespace

void Staged::place(const BuiltIn& built_in, const Transform& motion) {
  const std::size_t count = std::min(built_in.scene.instances.size(), instances_.size());
  for (std::size_t i = 0; i < count; ++i) {
    instances_[i] = built_in.scene.instances[i];
    instances_[i].transform = combine(motion, instances_[i].transform);
  }
  scene = built_in.scene;
  scene.instances = {instances_.data(), count};
}

Transform turned(const Transform& at_rest, std::uint32_t frame, std::uint32_t frames) {
  return combine(about_y(rotation_by(turn(frame, frames))), at_rest);
}

Camera turned(const Camera& at_rest, std::uint32_t frame, std::uint32_t frames) {
  const Rotation rotation = rotation_by(turn(frame, frames));
  Camera camera = at_rest;
  for (Vec3* vector : {&camera.right, &camera.up, &camera.back, &camera.eye}) {
    *vector = turned_about_y(*vector, rotation);
  }
  return camera;
}

bool can_turn(const Transform& transform) {
  return std::all_of(std::begin(transform.m), std::end(transform.m),
                     [](const Fixed(&row)[4]) { return is_near(row[3]); });
}

bool can_turn(const Camera& camera) { return is_near(camera.eye.x) && is_near(camera.eye.y) && is_near(camera.eye.z); }

Camera fit_width(const Camera& camera, const View& own, const View& view) {
  const std::uint64_t ratio = std::uint64_t{view.width} * own.height;
  const std::uint64_t own_ratio = std::uint64_t{own.width} * view.height;
  Camera fitted = camera;
  if (ratio < own_ratio) {
    const std::uint64_t focal = static_cast<std::uint64_t>(camera.focal) * ratio / own_ratio;
    fitted.focal = static_cast<Fixed>(std::max<std::uint64_t>(focal, 1));
  }
  return fitted;
}

void stage(const BuiltIn& built_in, Staged& staged, std::uint32_t frame, std::uint32_t frames, const View& view) {
  const bool model_turns = built_in.turns == Turns::model;
  staged.place(built_in, model_turns ? about_y(rotation_by(turn(frame, frames))) : Transform::identity());
  const Camera camera = fitted_camera(built_in, view);
  staged.camera = model_turns ? camera : turned(camera, frame, frames);
}

void stage_workload(const BuiltIn& built_in, Staged& staged, std::uint32_t frame) {
  if (built_in.pose != nullptr) {
    staged.place(built_in, Transform::identity());
    staged.camera = built_in.camera;
    return;
  }
  const auto about_y_angle = static_cast<Angle>((frame * kWorkloadStep) >> 16);
  const auto about_x_angle = static_cast<Angle>((frame * kWorkloadHalfStep) >> 16);
  staged.place(built_in, combine(about_x(rotation_by(about_x_angle)), about_y(rotation_by(about_y_angle))));
  staged.camera = {};  // 60 degrees, near 0.1, far 100
  staged.camera.eye = {0, 0, built_in.workload_distance};
}

}  // namespace zstrip::scenes
