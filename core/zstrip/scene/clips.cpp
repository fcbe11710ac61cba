// Poses joints, morph targets and instances by the clips that play.
#include "zstrip/clips.hpp"

#include <algorithm>
#include <cstddef>
#include <new>

#include "zstrip/scene/keyframes.hpp"

namespace zstrip {
namespace {

// pose_skin writes all matrices after the last blend, so that until then their memory has the pose to blend with.
static_assert(sizeof(JointPose) <= sizeof(Transform) && alignof(JointPose) <= alignof(Transform));

std::span<JointPose> rest_in(std::span<Transform> matrices, std::span<const JointPose> rest) {
  auto* const first = reinterpret_cast<JointPose*>(matrices.data());
  for (std::size_t i = 0; i < rest.size(); ++i) ::new (first + i) JointPose(rest[i]);
  return {first, rest.size()};
}

void as_matrices(std::span<Transform> matrices) {
  for (Transform& matrix : matrices) ::new (&matrix) Transform;
}

/// Returns an instance's transform in a clip: that at rest if it has no track.
Transform placed_by(const Animation& animation, std::uint32_t time, std::size_t instance, const Transform& at_rest) {
  for (const Track& track : animation.tracks) {
    if (track.instance != instance) continue;
    const auto [from, to, share] = detail::interval_at(animation, track, time);
    return detail::placed(detail::between(from->rotation, to->rotation, share),
                          detail::between(from->translation, to->translation, share),
                          detail::between(from->scale, to->scale, share));
  }
  return at_rest;
}

}  // namespace

Status pose_clips(std::span<const Clip> clips, std::span<const PlayedClip> played, const MovedSkins& moved) {
  if (moved.skinnings.empty()) return {};
  const std::span<const JointPose> rest = moved.skinnings[0].skin->rest;
  const std::span<Transform> matrices = moved.skinnings[0].matrices;
  std::copy(rest.begin(), rest.end(), moved.pose.begin());
  if (clips.empty()) played = {};
  for (std::size_t i = 0; i < played.size(); ++i) {
    const Animation& joints = clips[played[i].clip].joints;
    if (i == 0) {
      pose(joints, played[i].time, moved.pose);
      continue;
    }
    const std::span<JointPose> others = rest_in(matrices, rest);
    pose(joints, played[i].time, others);
    blend(moved.pose, others, played[i].share());
    as_matrices(matrices);
  }
  Status status;
  for (Skinning& skinning : moved.skinnings) {
    const Status posed = pose_skin(skinning, moved.pose);
    if (status) status = posed;
  }
  return status;
}

Status pose_clips(std::span<const Clip> clips, std::span<const PlayedClip> played, const MovedMorphs& moved) {
  const std::span<MorphWeight> weights = moved.weights;
  std::fill(weights.begin(), weights.end(), MorphWeight{0});
  if (clips.empty()) played = {};
  for (std::size_t i = 0; i < played.size(); ++i) {
    const WeightAnimation& animation = clips[played[i].clip].weights;
    if (i == 0) {
      pose(animation, played[i].time, weights);
      continue;
    }
    for (std::size_t n = 0; n < weights.size(); ++n) {
      const MorphWeight before = weights[n];
      weights[n] = 0;
      for (const Track& track : animation.tracks) {
        if (track.instance == n) pose({{&track, 1}, animation.keys, animation.duration}, played[i].time, weights);
      }
      weights[n] = static_cast<MorphWeight>(detail::between(before, weights[n], played[i].share()));
    }
  }
  Status status;
  for (const MovedMorph& mesh : moved.meshes) {
    const Status morphed = morph_mesh(mesh.morph, weights, mesh.vertices);
    if (status) status = morphed;
  }
  return status;
}

void pose_clips(std::span<const Clip> clips, std::span<const PlayedClip> played, std::span<const Instance> at_rest,
                std::span<Instance> instances) {
  std::copy(at_rest.begin(), at_rest.end(), instances.begin());
  for (std::size_t i = 0; i < played.size(); ++i) {
    const Animation& animation = clips[played[i].clip].instances;
    if (i == 0) {
      pose(animation, played[i].time, instances);
      continue;
    }
    const std::uint32_t share = played[i].share();
    for (std::size_t n = 0; n < instances.size(); ++n) {
      const Transform other = placed_by(animation, played[i].time, n, at_rest[n].transform);
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
          Fixed& value = instances[n].transform.m[row][column];
          value = detail::between(value, other.m[row][column], share);
        }
      }
    }
  }
}

}  // namespace zstrip
