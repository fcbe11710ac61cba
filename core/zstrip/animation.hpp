// Instances that move by keyframes: translation, rotation and scale, in flash or in a blob, posed into instances in
// RAM:
//     std::copy(kScene.instances...) into `instances`; each frame: pose(kAnimation, milliseconds, instances);
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/scene.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

/// Where an instance is at a time: scaled, then rotated, then moved.
struct Keyframe {
  std::uint32_t time;        ///< milliseconds from the animation's start
  std::int16_t rotation[4];  ///< 1.15, a unit quaternion: x, y, z, w
  Vec3 translation;          ///< 16.16
  Vec3 scale;                ///< 16.16, +-255
};

/// The motion of one instance: a run of Animation::keyframes, later ones with greater times. Before the first and after
/// the last it stands still; between two, translation and scale are interpolated linearly, rotations along the shorter
/// arc.
struct Track {
  std::uint16_t instance;  ///< index into Scene::instances
  std::uint16_t count;     ///< of its keyframes, at least 1
  std::uint32_t first;     ///< index into Animation::keyframes
};

/// Motion of a scene's instances, which begins again when it ends. A view of tables in flash or in a blob.
struct Animation {
  std::span<const Track> tracks;        ///< empty: nothing moves
  std::span<const Keyframe> keyframes;  ///< of all tracks
  std::uint32_t duration = 0;           ///< milliseconds, > 0 if there are tracks; begins again after it
};

/// Error::animation (`needed` = index of the track) for what does not exist, times that do not grow, quaternions that
/// are not of unit length or more than half a turn from the one before (as vectors of four: choose the nearer sign),
/// scales out of range. What passes is safe to pose with as many instances.
Status validate(const Animation& animation, std::uint32_t instances);

/// Sets the transforms of the instances that have tracks to what they are `time` milliseconds after the start; any
/// time. `instances`: as many as in validate. The same bits on every target.
void pose(const Animation& animation, std::uint32_t time, std::span<Instance> instances);

/// The time of frame `frame` of `frames` (> 0) that show the animation once, any frame number.
constexpr std::uint32_t time_of_frame(const Animation& animation, std::uint32_t frame, std::uint32_t frames) {
  return static_cast<std::uint32_t>(std::uint64_t{animation.duration} * (frame % frames) / frames);
}

}  // namespace zstrip
