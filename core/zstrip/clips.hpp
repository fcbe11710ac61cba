// Plays the clips of a model: named animations of instances, joints and weights of morph targets that repeat or end,
// and fade into each other.
//     PlayedClips played;                                  // clip 0 from its beginning
//     played.play(kWave, 300);                             // walks on while it becomes waving, for 300 milliseconds
//     played.advance(milliseconds, clips);                 // before each frame
//     pose_clips(clips, played.all(), moved);              // and renderer.begin_frame(...)
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"
#include "zstrip/morph.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/skin.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

/// A named animation of instances, joints and weights. All parts last equally long, more than 0 milliseconds; each may
/// have no tracks.
struct Clip {
  const char* name = "";      ///< UTF-8
  Animation instances;        ///< moves instances
  Animation joints;           ///< Track::instance is the joint
  WeightAnimation weights{};  ///< Track::instance is the weight

  /// Returns the milliseconds until it repeats.
  constexpr std::uint32_t duration() const { return instances.duration; }
};

/// Skins that have the same joints, and the memory for their pose.
struct MovedSkins {
  std::span<Skinning> skinnings;  ///< one a mesh
  std::span<JointPose> pose;      ///< one a joint
};

/// A mesh with morph targets, and the memory for its vertices.
struct MovedMorph {
  Morph morph;             ///< of the mesh as it was modelled
  MovedVertices vertices;  ///< those of the scene's mesh
  std::uint16_t mesh = 0;  ///< its index in the scene
};

/// Meshes with morph targets, which have the same weights.
struct MovedMorphs {
  std::span<const MovedMorph> meshes;  ///< each with its targets and the memory of the moved vertices
  std::span<MorphWeight> weights;      ///< of the pose, one for each weight of the blob
};

/// A number that a program gets when a clip comes to a time: a foot touches the ground, a word begins.
struct ClipEvent {
  std::uint16_t clip;    ///< its index
  std::uint16_t number;  ///< any
  std::uint32_t time;    ///< milliseconds after the clip's start, less than its duration
};

/// Returns an event of a clip that has been due since the call before, the earliest one; null if there is none. Call it
/// until there is none, at least once in the clip's `duration`: the clip may have begun again meanwhile. `time`: of the
/// clip, less than `duration`. `from`: the earliest time that is due, 0 when the clip begins, up to `duration`; this
/// sets it for the next call.
constexpr const ClipEvent* next_event(std::span<const ClipEvent> events, std::uint16_t clip, std::uint32_t time,
                                      std::uint32_t duration, std::uint32_t& from) {
  const auto since_from = [&](std::uint32_t at) { return at >= from ? at - from : at + (duration - from); };
  const ClipEvent* next = nullptr;
  for (const ClipEvent& event : events) {
    if (event.clip != clip || since_from(event.time) >= since_from(time + 1)) continue;
    if (next == nullptr || since_from(event.time) < since_from(next->time)) next = &event;
  }
  from = (next != nullptr ? next->time : time) + 1;
  return next;
}

/// A clip that plays, at one time.
struct PlayedClip {
  std::uint32_t time = 0;   ///< milliseconds after the clip's start, less than its duration
  std::uint16_t clip = 0;   ///< its index
  std::uint16_t fade = 0;   ///< milliseconds in which the clips that played before become this one
  std::uint16_t faded = 0;  ///< milliseconds of `fade` that have passed, at most `fade`
  bool loops = true;        ///< if not, the clip stops a millisecond before its end

  /// Returns the clip's share of the pose, in 1/65536.
  constexpr std::uint32_t share() const { return faded >= fade ? 65536 : (std::uint32_t{faded} << 16) / fade; }
};

/// The clips that play: the last one is the clip that was chosen last; the others fade into it, and go on meanwhile.
class PlayedClips {
 public:
  static constexpr std::uint32_t kMaxPlayed = 4;  ///< a fifth takes the place of the first one at once

  /// Begins `clip`, which must exist in the calls that follow. The clips that play become this one in `fade`
  /// milliseconds; 0: at once.
  constexpr void play(std::uint16_t clip, std::uint16_t fade = 0, bool loops = true) {
    if (count_ == kMaxPlayed) drop(1);
    clips_[count_++] = {.time = 0, .clip = clip, .fade = fade, .faded = 0, .loops = loops};
    settle();
  }
  /// Moves all clips that play on.
  constexpr void advance(std::uint32_t milliseconds, std::span<const Clip> clips) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      PlayedClip& played = clips_[i];
      const std::uint32_t duration = clips[played.clip].duration(), rest = duration - played.time;
      if (played.loops) {
        const std::uint32_t step = milliseconds % duration;
        played.time = step < rest ? played.time + step : step - rest;
      } else {
        played.time = milliseconds < rest ? played.time + milliseconds : duration - 1;
      }
      const std::uint32_t left = static_cast<std::uint32_t>(played.fade - played.faded);
      played.faded = milliseconds < left ? static_cast<std::uint16_t>(played.faded + milliseconds) : played.fade;
    }
    settle();
  }
  /// Sets the last clip to a time, without the clips before it.
  constexpr void seek(std::uint32_t time, std::span<const Clip> clips) {
    PlayedClip& played = clips_[count_ - 1];
    played.time = time % clips[played.clip].duration();
    played.faded = played.fade;
    settle();
  }

  /// Returns the clip that was played last, which the others fade into.
  constexpr const PlayedClip& last() const { return clips_[count_ - 1]; }
  /// Returns the clips in the order in which they fade into each other, at least one. The share of the first one does
  /// not count.
  constexpr std::span<const PlayedClip> all() const { return {clips_, count_}; }

 private:
  constexpr void drop(std::uint32_t count) {
    for (std::uint32_t i = count; i < count_; ++i) clips_[i - count] = clips_[i];
    count_ -= count;
  }
  /// Drops the clips of which nothing is left.
  constexpr void settle() {
    for (std::uint32_t i = count_; i-- > 1;) {
      if (clips_[i].faded >= clips_[i].fade) return drop(i);
    }
  }

  PlayedClip clips_[kMaxPlayed];
  std::uint32_t count_ = 1;
};

/// Moves the joints of all skins, before the frame that shows them: pose() of the first clip over the joints' rest,
/// then for each other clip blend() with its pose, by its share. The result has the same bits on every target. Safe for
/// skins and animations that passed validate; nothing happens without skins. Error::skin as from pose_skin: that skin
/// then stands as it was modelled. Without clips the joints rest.
Status pose_clips(std::span<const Clip> clips, std::span<const PlayedClip> played, const MovedSkins& moved);

/// Moves the meshes by their morph targets, before the frame that shows them: weights are 0, then those of pose() of
/// the first clip; each other clip moves all weights linearly towards its own, by its share. A skin of the same mesh
/// moves the morphed vertices. Safe for morphs and animations that passed validate. Error::skin as from morph_mesh.
Status pose_clips(std::span<const Clip> clips, std::span<const PlayedClip> played, const MovedMorphs& moved);

/// Writes the instances at rest, moved by the clips, to `instances`, which are as many. During a fade each entry of a
/// transform goes linearly from one clip's to the other's.
void pose_clips(std::span<const Clip> clips, std::span<const PlayedClip> played, std::span<const Instance> at_rest,
                std::span<Instance> instances);

}  // namespace zstrip
