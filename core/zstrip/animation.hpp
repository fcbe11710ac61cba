// Moves instances by keyframes. The tables of translation, rotation and scale lie in flash or in a blob; pose() writes
// the result into instances in RAM:
//     std::copy(kScene.instances...) into `instances`; each frame: pose(kAnimation, milliseconds, instances);
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/scene.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

/// The place of an instance at one time. The instance is scaled, then rotated, then moved.
struct Keyframe {
  std::uint32_t time;        ///< milliseconds from the animation's start
  std::int16_t rotation[4];  ///< 1.15, a unit quaternion: x, y, z, w
  Vec3 translation;          ///< 16.16
  Vec3 scale;                ///< 16.16, +-255
};

/// The motion of one instance: a run of Animation::keyframes with ascending times. The instance stands still before the
/// first keyframe and after the last one. Between two keyframes translation and scale are interpolated linearly, and
/// the rotation along the shorter arc.
struct Track {
  std::uint16_t instance;  ///< index into Scene::instances
  std::uint16_t count;     ///< number of its keyframes, at least 1
  std::uint32_t first;     ///< index into Animation::keyframes
};

/// The animation of a scene, which repeats. The tables lie in flash or in a blob.
struct Animation {
  std::span<const Track> tracks;        ///< empty: nothing moves
  std::span<const Keyframe> keyframes;  ///< keyframes of all tracks
  std::uint32_t duration = 0;           ///< milliseconds, > 0 if there are tracks; then the motion repeats
};

/// Returns Error::animation (`needed` = index of the track) if an index is out of range, times do not grow, a
/// quaternion is not of unit length, its dot product with the one before is negative (a rotation by more than 180
/// degrees: choose the other sign), or a scale is out of range. An animation that passes is safe to pose with as many
/// instances.
Status validate(const Animation& animation, std::uint32_t instances);

/// Sets the transforms of all instances that have tracks to their values `time` milliseconds after the start; any time
/// is valid. `instances`: as many as in validate. The result has the same bits on every target.
void pose(const Animation& animation, std::uint32_t time, std::span<Instance> instances);

/// Returns the time in milliseconds of frame `frame` when `frames` frames (> 0) show the animation once; any frame
/// number.
constexpr std::uint32_t time_of_frame(const Animation& animation, std::uint32_t frame, std::uint32_t frames) {
  return static_cast<std::uint32_t>(std::uint64_t{animation.duration} * (frame % frames) / frames);
}

}  // namespace zstrip
