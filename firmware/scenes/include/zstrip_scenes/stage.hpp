// Sets a built-in scene in motion. Boards, host command, tests and benchmarks all use these functions, which compute
// with integers, so that frame n is the same picture everywhere.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "zstrip/view.hpp"
#include "zstrip_scenes/built_in.hpp"

namespace zstrip::scenes {

/// One frame of a built-in scene, ready for begin_frame: `scene` reads the instances in this object; all other data
/// stays in flash. The object must not move, because `scene` points into it; it can be staged again for the next frame.
class Staged {
 public:
  Staged() = default;
  Staged(const Staged&) = delete;
  Staged& operator=(const Staged&) = delete;

  Scene scene;
  Camera camera;

 private:
  friend void stage(const BuiltIn&, Staged&, std::uint32_t, std::uint32_t, const View&);
  friend void stage_workload(const BuiltIn&, Staged&, std::uint32_t);
  /// Stages the scene at rest, with every instance moved by `motion`.
  void place(const BuiltIn& built_in, const Transform& motion);

  std::array<Instance, kMaxInstances> instances_;
};

/// Returns the turntable's camera at frame 0, fitted to the picture as in stage(); rounds the focal length down.
constexpr Camera fitted_camera(const BuiltIn& built_in, const View& view) {
  Camera camera = built_in.camera;
  const std::uint32_t across = static_cast<std::uint32_t>(built_in.focal_across) * view.width / view.height;
  camera.focal = static_cast<Fixed>(std::min(static_cast<std::uint32_t>(camera.focal), across));
  return camera;
}

/// Stages the turntable: frame `frame` of a rotation by 360 degrees in `frames` frames (0 counts as 1), any frame
/// number. The camera stands slightly above; its focal length is fitted to the ratio of `view`'s width to its height
/// (1..4096 each), so that the model fills the picture and stays inside it.
void stage(const BuiltIn& built_in, Staged& staged, std::uint32_t frame, std::uint32_t frames,
           const View& view = {.width = 320, .height = 240});

inline constexpr Fixed kFarthestTurned = 1 << 30;  // 16.16

/// Rotates `at_rest` about the world's y axis, as the turntable does, for your own scenes: frame `frame` of a rotation
/// by 360 degrees in `frames` frames (0 counts as 1), any frame number. Translations must be within kFarthestTurned of
/// the origin.
Transform turned(const Transform& at_rest, std::uint32_t frame, std::uint32_t frames);

/// Rotates the camera about the world's y axis in the same way, around a fixed scene; eye within kFarthestTurned.
Camera turned(const Camera& at_rest, std::uint32_t frame, std::uint32_t frames);

bool can_turn(const Transform& transform);
/// True if the camera's eye is within kFarthestTurned.
bool can_turn(const Camera& camera);

/// Returns the camera of a scene that was baked for the picture `own`, for another picture: if `view` is narrower, it
/// shows the same width. Rounds the focal length down.
Camera fit_width(const Camera& camera, const View& own, const View& view);

/// Stages the motion of the benchmarks: vertical field of view 60 degrees, near 0.1, far 100, camera on +z looking at
/// -z, the model rotated by a about y, then by a/2 about x, with a = 0.1 radians a frame. Angles are in 0.32 of a full
/// circle and wrap: any frame number. A scene with BuiltIn::pose does not rotate, and its own camera is used.
void stage_workload(const BuiltIn& built_in, Staged& staged, std::uint32_t frame);

}  // namespace zstrip::scenes
