// All effects: their names, and their exclusions.
#pragma once

#include <array>
#include <cstddef>

#include "zstrip/effects/billboards/effect.hpp"
#include "zstrip/effects/blending/effect.hpp"
#include "zstrip/effects/csg/effect.hpp"
#include "zstrip/effects/dithering/effect.hpp"
#include "zstrip/effects/edges/effect.hpp"
#include "zstrip/effects/effect.hpp"
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
#include "zstrip/effects/skins/effect.hpp"
#include "zstrip/effects/unclipped/effect.hpp"
#include "zstrip/visibility/exclusions.hpp"

namespace zstrip::detail {

/// They exist only in the loops of geometry and raster.
struct EffectsWithoutWing : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::lighting, "lighting", "lit, with normals"},
      {effect::gouraud, "gouraud", "smooth shading"},
      {effect::vertex_colours, "vertex_colours", "vertex colours"},
      {effect::textures, "textures", "a texture and texture coordinates"},
      {effect::orthographic, "orthographic", "the camera's parallel projection"},
      {effect::depth_state, "depth_state", "a depth test, depth write or bias of its own"},
      {effect::bins, "bins", "the plan transforms geometry only once (--mode)"},
  };
  static constexpr Exclusion kExclusions[] = {
      {effect::orthographic, effect::depth_float,
       "the small float keeps 1/w, which is the same everywhere without perspective"},
  };
};

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

using DescribedEffects =
    EffectList<EffectsWithoutWing, fog::Effect, local_light::Effect, fragments::Effect, blending::Effect,
               quadrics::Effect, lines::Effect, billboards::Effect, environment::Effect, outlines::Effect,
               shadows::Effect, csg::Effect, edges::Effect, overlay::Effect, pixel_shading::Effect, dithering::Effect,
               unclipped::Effect, skins::Effect, samples::Effect, methods::Described>;

}  // namespace zstrip::detail

namespace zstrip {

/// All effects that a scene, its picture or its plan can need, each once, with the names for reports and options.
inline constexpr auto kEffectNames = detail::DescribedEffects::names();

static_assert(
    [] {
      Effects named{};
      for (const EffectName& each : kEffectNames) {
        if (named.any(each.effect)) return false;
        named = named | each.effect;
      }
      return named == (effect::of_scenes | effect::bins | effect::unclipped);
    }(),
    "an effect without a name, or with two");

}  // namespace zstrip
