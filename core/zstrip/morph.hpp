// Moves vertices of a mesh by morph targets (blend shapes), before a frame, into a mesh in RAM, which the scene draws
// like any other mesh, with every effect, method and mode, and without code for morphs in the renderer. A target is a
// list of offsets for some vertices; each target counts by its weight:
//     pose(kWeightAnimation, milliseconds, weights);       // MorphWeight weights[...]
//     morph_mesh(kMorph, weights, {positions, normals, meshlets});
//     renderer.begin_frame(...);
// A skin may move the morphed mesh further, in the same memory: Skin::mesh is then moved_mesh(mesh, moved).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/skin.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

/// The share of a target's offsets that is added, 4.12: 4096 adds them once; negative shares subtract them.
using MorphWeight = std::int16_t;
inline constexpr std::int32_t kMorphOne = 4096;  ///< a weight of 1

/// An offset of a vertex, in steps of Position.
struct MorphOffset {
  std::int16_t x, y, z;  ///< any values
};

/// An offset of a normal, in two steps of Normal: 2/127.
struct NormalOffset {
  std::int8_t x, y, z;  ///< any values
};

/// A run of vertices that a target moves, one offset each.
struct MorphRun {
  std::uint16_t first_vertex;  ///< index into Mesh::positions
  std::uint16_t count;         ///< number of its vertices, at least 1
  std::uint16_t first_offset;  ///< index into MorphTarget::positions, and into normals if there are any
};

/// A shape towards which the vertices of the runs move; all others stay.
struct MorphTarget {
  std::uint16_t weight = 0;                    ///< index into the weights
  std::span<const MorphRun> runs;              ///< ascending, without a common vertex; empty: the target moves nothing
  std::span<const MorphOffset> positions;      ///< of the runs' vertices
  std::span<const NormalOffset> normals = {};  ///< as many as `positions`, or empty: normals do not change
};

/// A mesh and its targets, in flash.
struct Morph {
  const Mesh* mesh = nullptr;            ///< with all weights 0; its half extents are equal, and its box has room for
                                         ///< the weights that are used
  std::span<const MorphTarget> targets;  ///< at least 1; two may have one weight
};

/// A weight at one time.
struct WeightKey {
  std::uint32_t time;  ///< milliseconds from the animation's start
  MorphWeight weight;  ///< 4.12
};

/// The animation of weights, which repeats. Track::instance is the index of a weight, and Track::first an index into
/// `keys`. Weights are constant before a track's first key and after its last one, and linear between two keys.
struct WeightAnimation {
  std::span<const Track> tracks;    ///< empty: no weight changes
  std::span<const WeightKey> keys;  ///< keys of all tracks
  std::uint32_t duration = 0;       ///< milliseconds, > 0 if there are tracks; then the motion repeats
};

/// Returns Error::skin (`needed` = index of the target) if half extents differ, there is no target, a run has no
/// vertices, vertices that do not exist or that an earlier run has, or offsets that do not exist, or if counts differ.
constexpr Status validate(const Morph& morph) {
  const auto wrong = [](std::size_t index) {
    return Status{.error = Error::skin, .needed = static_cast<std::uint32_t>(index)};
  };
  if (morph.mesh == nullptr || morph.targets.empty()) return wrong(0);
  const Mesh& mesh = *morph.mesh;
  const Vec3& half = mesh.half_extent;
  if (half.x <= 0 || half.x != half.y || half.x != half.z || mesh.billboard != Billboard::none) return wrong(0);
  for (std::size_t i = 0; i < morph.targets.size(); ++i) {
    const MorphTarget& target = morph.targets[i];
    if (!target.normals.empty() && (target.normals.size() != target.positions.size() || mesh.normals.empty())) {
      return wrong(i);
    }
    std::size_t end = 0;  // of the run before
    for (const MorphRun& run : target.runs) {
      if (run.count == 0 || run.first_vertex < end) return wrong(i);
      end = std::size_t{run.first_vertex} + run.count;
      if (end > mesh.positions.size() || std::size_t{run.first_offset} + run.count > target.positions.size()) {
        return wrong(i);
      }
    }
  }
  return {};
}

/// Returns Error::animation (`needed` = index of the track) if a track has a weight or keys that do not exist, if times
/// do not grow, or if there is no duration. `weights`: their number.
constexpr Status validate(const WeightAnimation& animation, std::uint32_t weights) {
  for (std::size_t i = 0; i < animation.tracks.size(); ++i) {
    const Status wrong{.error = Error::animation, .needed = static_cast<std::uint32_t>(i)};
    const Track& track = animation.tracks[i];
    const std::size_t all = animation.keys.size();
    if (animation.duration == 0 || track.instance >= weights || track.count == 0) return wrong;
    if (track.first > all || track.count > all - track.first) return wrong;
    for (std::size_t k = track.first + std::size_t{1}; k < std::size_t{track.first} + track.count; ++k) {
      if (animation.keys[k].time <= animation.keys[k - 1].time) return wrong;
    }
  }
  return {};
}

/// Sets all weights that have tracks to their values `time` milliseconds after the start; any time is valid.
/// `weights`: as many as in validate. The result has the same bits on every target.
void pose(const WeightAnimation& animation, std::uint32_t time, std::span<MorphWeight> weights);

/// Writes the mesh as the weights move it: positions, normals of unchanged length, and meshlets with new bounding
/// spheres. Safe for morphs that passed validate. Error::skin (`needed` = index of the target) if a target's weight
/// does not exist, or if the absolute weights of all targets add up to 16 or more; with `needed` = 0 if a span has
/// another size; with `needed` = the vertex if it leaves the mesh's box: `moved` then holds the moved mesh, except that
/// such a vertex is at the box's side. Needs some 400 bytes of stack. Time: three products for each offset of a target
/// whose weight is not 0, six with a normal.
Status morph_mesh(const Morph& morph, std::span<const MorphWeight> weights, const MovedVertices& moved);

}  // namespace zstrip
