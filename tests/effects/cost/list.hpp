// The effects whose cost is measured, each with its scene: the one list that programs, tables and tests read.
#pragma once

#include <string_view>

#include "plain.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::effects_cost {

/// A scene, as it is or plain, and the pipeline for exactly what it calls for.
struct Drawing {
  const scenes::BuiltIn* scene;
  View view;
  Effects effects;
  Plan plan;
};

struct CostOfEffect {
  std::string_view effect;  ///< several with a + between them; with the samples where they matter
  std::string_view unit;    ///< what it costs something for
  Drawing with, without;
  Effects called_for;  ///< by the picture or the program, not by what is drawn
  Effects own;         ///< what is drawn is touched by the effect if it calls for one of these
};

template <const scenes::BuiltIn& built_in, bool plain>
constexpr Drawing drawing() {
  constexpr const scenes::BuiltIn& kScene = kChosen<built_in, plain>;
  constexpr View kPicture = kView<built_in, plain>;
  constexpr Effects kEffects = kEffectsOf<built_in, plain>;
  return {&kScene, kPicture, kEffects, plan(kScene.counts, kPicture, kEffects, {.strip_rows = kPicture.height}).plan};
}

template <const scenes::BuiltIn& built_in>
constexpr CostOfEffect cost_of(std::string_view effect, std::string_view unit) {
  return {effect,
          unit,
          drawing<built_in, false>(),
          drawing<built_in, true>(),
          effects_of(kView<built_in, false>) | kChoice<built_in>,
          kKeepsLight<built_in> ? effect::pixel_shading : kTaken<built_in>};
}

inline constexpr CostOfEffect kCosts[] = {
    cost_of<scenes::lit>("lighting", "vertex"),
    cost_of<scenes::smooth>("gouraud", "fragment"),
    cost_of<scenes::textured>("textures", "fragment"),
    cost_of<scenes::affine>("perspective_affine", "fragment"),
    cost_of<scenes::every_8>("perspective_8", "fragment"),
    cost_of<scenes::every_pixel>("perspective_1", "fragment"),
    cost_of<scenes::fog>("fog", "fragment"),
    cost_of<scenes::emissive>("emissive", "vertex"),
    cost_of<scenes::specular>("specular", "vertex"),
    cost_of<scenes::punctual>("punctual_lights", "vertex"),
    cost_of<scenes::mask>("alpha_test+texture_alpha", "fragment"),
    cost_of<scenes::blend>("blending", "fragment"),
    cost_of<scenes::bilinear>("bilinear", "fragment"),
    cost_of<scenes::palette>("texture_palettes", "fragment"),
    cost_of<scenes::mipmaps>("mipmaps", "fragment"),
    cost_of<scenes::environment>("environment", "vertex"),
    cost_of<scenes::per_pixel>("pixel_shading", "fragment"),
    cost_of<scenes::spheres>("quadrics", "fragment"),
    cost_of<scenes::dithered>("dithered_colours", "fragment"),
    cost_of<scenes::dithered_mono>("dithered_format", "pixel"),
    cost_of<scenes::lines>("lines", "fragment"),
    cost_of<scenes::billboards>("billboards", "instance"),
    cost_of<scenes::outlines>("outlines", "vertex"),
    cost_of<scenes::character>("skins", "vertex"),
    cost_of<scenes::shadows>("shadows", "fragment"),
    cost_of<scenes::csg>("csg", "fragment"),
    cost_of<scenes::edges>("edges", "edge"),
    cost_of<scenes::overlay>("overlay", "pixel"),
    cost_of<scenes::samples_2>("supersampled_2", "pixel"),
    cost_of<scenes::samples_4>("supersampled_4", "pixel"),
};

/// Of a program draw_BITS_METHODS: 2 * place in the list, and 1 more for the plain one.
constexpr const Drawing& drawing_at(std::size_t index) {
  const CostOfEffect& cost = kCosts[index / 2];
  return index % 2 == 0 ? cost.with : cost.without;
}

}  // namespace zstrip::effects_cost
