// All effects that have a wing, and how their parts of the arena lie behind each other.
#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>

#include "zstrip/effects/billboards/effect.hpp"
#include "zstrip/effects/blending/effect.hpp"
#include "zstrip/effects/changed_instances.hpp"
#include "zstrip/effects/csg/effect.hpp"
#include "zstrip/effects/dithering/effect.hpp"
#include "zstrip/effects/edges/effect.hpp"
#include "zstrip/effects/environment/effect.hpp"
#include "zstrip/effects/fog/effect.hpp"
#include "zstrip/effects/fragments/effect.hpp"
#include "zstrip/effects/lines/effect.hpp"
#include "zstrip/effects/local_light/effect.hpp"
#include "zstrip/effects/outlines/effect.hpp"
#include "zstrip/effects/overlay/effect.hpp"
#include "zstrip/effects/pixel_shading/effect.hpp"
#include "zstrip/effects/quadrics/effect.hpp"
#include "zstrip/effects/samples/effect.hpp"
#include "zstrip/effects/shadows/effect.hpp"
#include "zstrip/effects/without_wing.hpp"

namespace zstrip::detail {

/// Ahead of all parts: which of them there are, and of how many instances.
inline constexpr std::uint32_t kEffectHeaderBytes = 16;

/// The last parts may count something else than instances; of these no scene has two.
template <class... Parts>
struct EffectMemory {
  /// Whether effects among these have any memory.
  static constexpr bool has_any(Effects effects) { return effects.any((Parts::kNeedMemory | ...)); }

  /// Of all parts, and what is ahead of them. `called_for`: no other than `possible`, for which alone there is code.
  template <Effects possible = (Parts::kNeedMemory | ...)>
  static constexpr std::uint64_t bytes(Effects called_for, const SceneCounts& counts) {
    if (!has_any(called_for)) return 0;
    std::uint64_t end = kEffectHeaderBytes;
    (add_possible<possible, Parts>(end, called_for, counts), ...);
    return end;
  }

  /// Where a part begins that is called for.
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

template <class... Described>
struct EffectList {
  static constexpr auto names() {
    std::array<EffectName, (std::size(Described::kNames) + ...)> all{};
    std::size_t count = 0;
    (append(all, count, Described::kNames), ...);
    return all;
  }
  static constexpr auto exclusions() {
    std::array<Exclusion, (std::size(Described::kExclusions) + ...)> all{};
    std::size_t count = 0;
    (append(all, count, Described::kExclusions), ...);
    return all;
  }

 private:
  static constexpr void append(auto& all, std::size_t& count, const auto& more) {
    for (const auto& each : more) all[count++] = each;
  }
};

using DescribedEffects = EffectList<EffectsWithoutWing, fog::Effect, local_light::Effect, fragments::Effect,
                                    blending::Effect, quadrics::Effect, lines::Effect, billboards::Effect,
                                    environment::Effect, outlines::Effect, shadows::Effect, csg::Effect, edges::Effect,
                                    overlay::Effect, pixel_shading::Effect, dithering::Effect, samples::Effect>;

}  // namespace zstrip::detail

namespace zstrip {

/// All effects that a scene, its picture or its plan can call for, each once, as reports and options name them.
inline constexpr auto kEffectNames = detail::DescribedEffects::names();

static_assert(
    [] {
      Effects named{};
      for (const EffectName& each : kEffectNames) {
        if (named.any(each.effect)) return false;
        named = named | each.effect;
      }
      return named == (effect::of_scenes | effect::bins);
    }(),
    "an effect without a name, or with two");

}  // namespace zstrip
