// Strips, bins, supersets and bakes leave the pixels of every effect's scene as they are, and the effect shows.
#include <array>
#include <cstring>

#include "drawn.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/stage.hpp"

namespace effects_test::invariance_test {
namespace {

constexpr View kView{75, 58, PixelFormat::rgb565};
constexpr std::uint32_t kFrame = 3, kFrames = 20;

/// A scene with its exact pipeline; the scene without its effect must look different.
template <const scenes::BuiltIn& built_in>
struct Subject {
  static constexpr Effects kEffects = effects_of(built_in.scene, built_in.camera);

  static void check() {
    SCOPED_TRACE(built_in.name);
    scenes::Staged staged;
    scenes::stage(built_in, staged, kFrame, kFrames, kView);
    const auto exact = [&](const Budget& budget) { return draw<kEffects>(staged.scene, staged.camera, kView, budget); };
    const Drawn whole = exact({});
    for (const std::uint16_t rows : {std::uint16_t{1}, std::uint16_t{7}, std::uint16_t{30}}) {
      EXPECT_EQ(exact({.strip_rows = rows}), whole) << rows << " rows";
      EXPECT_EQ(exact({.strip_rows = rows, .strip_columns = 24}), whole) << rows << " rows of 24";
    }
    const Drawn binned = draw<kEffects | effect::bins>(staged.scene, staged.camera, kView,
                                                       {.strip_rows = 9, .strip_columns = 40, .modes = Modes::binned});
    EXPECT_EQ(binned, whole);
    EXPECT_EQ(draw_any(kEffects, staged.scene, staged.camera, kView, {.strip_rows = 11}), whole);
    EXPECT_EQ(draw_any(kEffects | effect::bins, staged.scene, staged.camera, kView,
                       {.strip_rows = 9, .modes = Modes::binned}),
              whole);
  }
};

TEST(EffectsInvariance, FogIsTheSameInStripsBinsAndSupersets) { Subject<scenes::fog>::check(); }

TEST(EffectsInvariance, EmissiveIsTheSameInStripsBinsAndSupersets) { Subject<scenes::emissive>::check(); }
TEST(EffectsInvariance, SpecularIsTheSameInStripsBinsAndSupersets) { Subject<scenes::specular>::check(); }
TEST(EffectsInvariance, PunctualIsTheSameInStripsBinsAndSupersets) { Subject<scenes::punctual>::check(); }
TEST(EffectsInvariance, MaskIsTheSameInStripsBinsAndSupersets) { Subject<scenes::mask>::check(); }
TEST(EffectsInvariance, BlendIsTheSameInStripsBinsAndSupersets) { Subject<scenes::blend>::check(); }
TEST(EffectsInvariance, BilinearIsTheSameInStripsBinsAndSupersets) { Subject<scenes::bilinear>::check(); }
TEST(EffectsInvariance, PaletteIsTheSameInStripsBinsAndSupersets) { Subject<scenes::palette>::check(); }
TEST(EffectsInvariance, MipmapsAreTheSameInStripsBinsAndSupersets) { Subject<scenes::mipmaps>::check(); }

// What a superset draws where the effect is absent must come from the same loops.
TEST(EffectsInvariance, SupersetsDrawScenesWithoutEffectsAlike) {
  const auto check = [](const scenes::BuiltIn& built_in) {
    SCOPED_TRACE(built_in.name);
    scenes::Staged staged;
    scenes::stage(built_in, staged, kFrame, kFrames, kView);
    const Effects exact = effects_of(staged.scene, staged.camera);
    EXPECT_EQ(draw_any(exact | effect::fog | effect::specular, staged.scene, staged.camera, kView),
              draw_any(exact, staged.scene, staged.camera, kView));
  };
  check(scenes::room);
  check(scenes::knot);
  check(scenes::cube);
}

}  // namespace
}  // namespace effects_test::invariance_test
