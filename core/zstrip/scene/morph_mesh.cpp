// Moves a mesh by its morph targets, some vertices at a time, so that sums need no memory for a whole mesh.
#include "zstrip/morph.hpp"

#include <algorithm>
#include <cstddef>

#include "zstrip/base/unit_vector.hpp"
#include "zstrip/scene/bound_meshlet.hpp"
#include "zstrip/scene/keyframes.hpp"
#include "zstrip/scene/move_vertices.hpp"

namespace zstrip {
namespace {

/// Vertices that are moved together.
constexpr std::size_t kBlock = 32;
/// Limit for the sum of absolute weights, 4.12: with it, no sum of products leaves 32 bits.
constexpr std::uint32_t kMaxWeights = 16 * kMorphOne - 1;
constexpr int kWeightBits = 12;

/// Weighted offsets of one vertex: steps of a position or a normal, with 12 fraction bits.
struct Sum {
  std::int32_t x, y, z;
};

/// Returns the first of the runs that end after `vertex`.
const MorphRun* run_after(std::span<const MorphRun> runs, std::size_t vertex) {
  std::size_t low = 0, high = runs.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (std::size_t{runs[middle].first_vertex} + runs[middle].count <= vertex) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return runs.data() + low;
}

/// Adds the offsets of a target to the sums of the vertices from `first` on.
template <class Offset>
void add(const MorphTarget& target, const Offset* offsets, std::int32_t weight, std::size_t first,
         std::span<Sum> sums) {
  const std::size_t end = first + sums.size();
  const MorphRun* const last = target.runs.data() + target.runs.size();
  for (const MorphRun* run = run_after(target.runs, first); run != last && run->first_vertex < end; ++run) {
    const std::size_t from = std::max<std::size_t>(run->first_vertex, first);
    const std::size_t to = std::min<std::size_t>(std::size_t{run->first_vertex} + run->count, end);
    const Offset* offset = offsets + run->first_offset + (from - run->first_vertex);
    for (Sum* sum = &sums[from - first]; sum != sums.data() + (to - first); ++sum, ++offset) {
      sum->x += weight * offset->x;
      sum->y += weight * offset->y;
      sum->z += weight * offset->z;
    }
  }
}

/// Adds the offsets of all targets. `offsets_of`(target): those of positions or of normals, or empty.
template <class OffsetsOf>
void add_all(const Morph& morph, std::span<const MorphWeight> weights, std::size_t first, std::span<Sum> sums,
             const OffsetsOf& offsets_of) {
  for (Sum& sum : sums) sum = {0, 0, 0};
  for (const MorphTarget& target : morph.targets) {
    const std::int32_t weight = weights[target.weight];
    const auto offsets = offsets_of(target);
    if (weight != 0 && !offsets.empty()) add(target, offsets.data(), weight, first, sums);
  }
}

/// Sets the position to base + offset. Returns false, and sets it to the side of the box, if it would lie outside.
bool set_position(const Position& base, const Sum& sum, Position& to) {
  bool inside = true;
  const auto moved = [&inside](std::int32_t from, std::int32_t offset) {
    const std::int32_t place = from + ((offset + (1 << (kWeightBits - 1))) >> kWeightBits);
    const std::int32_t limited = std::clamp<std::int32_t>(place, -32767, 32767);
    inside = inside && place == limited;
    return static_cast<std::int16_t>(limited);
  };
  to.x = moved(base.x, sum.x), to.y = moved(base.y, sum.y), to.z = moved(base.z, sum.z);
  return inside;
}

/// Sets the normal to the direction of base + offset, as long as the base; to the base if there is no direction.
void set_normal(const Normal& base, const Sum& sum, Normal& to) {
  const auto component = [](std::int32_t from, std::int32_t offset) { return (from << kWeightBits) + 2 * offset; };
  detail::UnitVector unit{0, 0, 0};
  if ((sum.x | sum.y | sum.z) != 0) {
    unit = detail::direction_of(component(base.x, sum.x), component(base.y, sum.y), component(base.z, sum.z)).unit;
  }
  if ((unit.x | unit.y | unit.z) != 0) {
    detail::set_direction(base, unit, to);
  } else {
    to = base;
  }
}

}  // namespace

void pose(const WeightAnimation& animation, std::uint32_t time, std::span<MorphWeight> weights) {
  for (const Track& track : animation.tracks) {
    const auto [from, to, share] =
        detail::interval_in(animation.keys.subspan(track.first, track.count), time % animation.duration);
    // From -2^16 to 2^16, times a share below 2^16: the product takes 33 bits.
    weights[track.instance] = static_cast<MorphWeight>(detail::between(from->weight, to->weight, share));
  }
}

Status morph_mesh(const Morph& morph, std::span<const MorphWeight> weights, const MovedVertices& moved) {
  const Mesh& mesh = *morph.mesh;
  const std::size_t count = mesh.positions.size();
  if (moved.positions.size() != count || moved.normals.size() != mesh.normals.size() ||
      moved.meshlets.size() != mesh.meshlets.size()) {
    return detail::wrong_skin(0);
  }
  std::uint32_t total = 0;
  for (std::size_t i = 0; i < morph.targets.size(); ++i) {
    const std::size_t index = morph.targets[i].weight;
    if (index >= weights.size()) return detail::wrong_skin(i);
    const std::int32_t weight = weights[index];
    total += static_cast<std::uint32_t>(weight < 0 ? -weight : weight);
    if (total > kMaxWeights) return detail::wrong_skin(i);
  }
  std::size_t outside = count;
  Sum sums[kBlock];
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::span block(sums, std::min(count - first, kBlock));
    add_all(morph, weights, first, block, [](const MorphTarget& target) { return target.positions; });
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::size_t vertex = first + i;
      if (!set_position(mesh.positions[vertex], sums[i], moved.positions[vertex])) outside = std::min(outside, vertex);
    }
    if (mesh.normals.empty()) continue;
    add_all(morph, weights, first, block, [](const MorphTarget& target) { return target.normals; });
    for (std::size_t i = 0; i < block.size(); ++i) {
      set_normal(mesh.normals[first + i], sums[i], moved.normals[first + i]);
    }
  }
  for (std::size_t i = 0; i < mesh.meshlets.size(); ++i) {
    moved.meshlets[i] = mesh.meshlets[i];
    detail::bound(moved.meshlets[i], moved.positions);
  }
  return outside == count ? Status{} : detail::wrong_skin(outside);
}

}  // namespace zstrip
