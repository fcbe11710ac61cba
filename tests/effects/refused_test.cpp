// What a renderer was built without is refused, and named.
#include "combination.hpp"

namespace effects_test {
namespace {

/// Regression: of csg, edges, overlay, skins and pixel_shading the status said only that something is missing.
TEST(EffectsTogether, ARendererWithoutAnEffectNamesIt) {
  for (const EffectName& each : kEffectNames) {
    // No scene calls for the first two; without the others a picture is not dithered.
    if (each.effect.any(effect::bins | effect::unclipped | effect::dithered_colours | effect::dithered_format))
      continue;
    SCOPED_TRACE(each.name);
    const Effects set = completed(each.effect);
    const View view = view_of(set);
    const Combination combination(set);
    ASSERT_EQ(without_shades(effects_of(combination.scene, combination.camera)) | effects_of(view), set);
    const Plan plan = zstrip::plan(count(combination.scene), view, set).plan;
    const auto status = [&](auto&& renderer) {
      return begun(renderer, combination.scene, combination.camera, view, plan);
    };
    EXPECT_EQ(status(Renderer<Effects{}>()), status(AnyRenderer(Effects{})));
    EXPECT_EQ(status(Renderer<Effects{}>()).error, Error::effect_missing);
    EXPECT_EQ(missing_effects(status(Renderer<Effects{}>())), set);
  }
  const Combination plain({});
  const View view = view_of({});
  const Plan binned =
      zstrip::plan(count(plain.scene), view, effect::bins, {.strip_rows = 9, .modes = Modes::binned}).plan;
  EXPECT_EQ(missing_effects(begun(Renderer<Effects{}>(), plain.scene, plain.camera, view, binned)), effect::bins);
}

}  // namespace
}  // namespace effects_test
