// The layout of the part of the arena in which effects keep data during a frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "zstrip/effects/blending/effect.hpp"
#include "zstrip/effects/csg/effect.hpp"
#include "zstrip/effects/edges/effect.hpp"
#include "zstrip/effects/effect.hpp"
#include "zstrip/effects/environment/effect.hpp"
#include "zstrip/effects/fog/effect.hpp"
#include "zstrip/effects/local_light/effect.hpp"
#include "zstrip/effects/outlines/effect.hpp"
#include "zstrip/effects/shadows/effect.hpp"

namespace zstrip::detail::changed_instances {

/// Rotated billboards, followed by hulls. They lie in the arena, because the caller's instances must not change.
struct Memory : AnyEffect {
  static constexpr Effects kNeedMemory = effect::billboards | effect::outlines;
  static constexpr std::uint32_t kInstanceBytes = 52;
  static constexpr std::uint64_t bytes(const SceneCounts& counts) {
    return std::uint64_t{counts.instances} * kInstanceBytes;
  }
};

static_assert(sizeof(Instance) == Memory::kInstanceBytes);

}  // namespace zstrip::detail::changed_instances

namespace zstrip::detail {

/// Bytes before all parts: the effects that have a part, and the number of instances.
inline constexpr std::uint32_t kEffectHeaderBytes = 16;

/// The last parts may count other elements than instances. A scene may have two of these parts only if they are those
/// of shadows and edges: the second one is found through the first one.
template <class... Parts>
struct EffectMemory {
  /// True if effects among these have any memory.
  static constexpr bool has_any(Effects effects) { return effects.any((Parts::kNeedMemory | ...)); }

  /// Returns the bytes of all parts and their header. `called_for` is a subset of `possible`, which alone has code.
  template <Effects possible = (Parts::kNeedMemory | ...)>
  static constexpr std::uint64_t bytes(Effects called_for, const SceneCounts& counts) {
    if (!has_any(called_for)) return 0;
    std::uint64_t end = kEffectHeaderBytes;
    (add_possible<possible, Parts>(end, called_for, counts), ...);
    return end;
  }

  /// Returns the offset of a part; the scene must need its effect.
  template <class Part>
  static constexpr std::size_t offset_of(Effects called_for, std::uint32_t instances) {
    static_assert((std::is_same_v<Part, Parts> || ...), "memory that nothing plans");
    const SceneCounts counts{.instances = instances};
    std::uint64_t end = kEffectHeaderBytes;
    bool found = false;
    ((found = found || std::is_same_v<Part, Parts>, found ? void() : add<Parts>(end, called_for, counts)), ...);
    return static_cast<std::size_t>(aligned<Part>(end));
  }

 private:
  template <class Part>
  static constexpr std::uint64_t aligned(std::uint64_t offset) {
    return (offset + Part::kAlignment - 1) / Part::kAlignment * Part::kAlignment;
  }
  template <Effects possible, class Part>
  static constexpr void add_possible(std::uint64_t& end, Effects called_for, const SceneCounts& counts) {
    if constexpr (possible.any(Part::kNeedMemory)) add<Part>(end, called_for, counts);
  }
  template <class Part>
  static constexpr void add(std::uint64_t& end, Effects called_for, const SceneCounts& counts) {
    if (called_for.any(Part::kNeedMemory)) end = aligned<Part>(end) + Part::bytes(counts);
  }
};

using MemoryOfEffects =
    EffectMemory<fog::Effect, blending::Effect, local_light::Effect, changed_instances::Memory, environment::Effect,
                 outlines::Effect, shadows::Effect, csg::Effect, edges::Effect>;

}  // namespace zstrip::detail
