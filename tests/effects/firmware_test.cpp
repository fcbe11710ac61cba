// No symbol of an effect is linked into a program for a board whose scene lacks the effect: none whose name says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "cost/k5.hpp"
#include "firmware_programs.hpp"
#include "markers.hpp"

namespace effects_test {
namespace {

TEST(FirmwareAbsence, ProgramsForBoardsHoldNoSymbolOfAnEffectThatTheirScenesLack) {
  const std::vector<Program> all = firmware_programs(ZSTRIP_FIRMWARE_BINARIES);
  EXPECT_GT(all.size(), 30U);
  for (const Program& program : all) EXPECT_EQ(misplaced(program, program.effects), "") << program.name;
}

TEST(FirmwareAbsence, ASymbolOfAnEffectThatTheSceneLacksIsSeen) {
  std::size_t looked_for = 0;
  for (const Program& program : firmware_programs(ZSTRIP_FIRMWARE_BINARIES)) {
    for (const Effects effect : {effect::shade_textured, effect::shade_textured_flat, effect::shade_textured_gouraud,
                                 effect::shade_flat, effect::bins, effect::depth_state, effect::depth_ranges,
                                 effect::depth_24, effect::perspective_1, method::painter, effect::gouraud}) {
      const bool is_drawn = effect != effect::gouraud || program.effects.has(effect::shade_gouraud);
      if (program.effects.has(effect) && is_drawn) {
        ++looked_for;
        EXPECT_NE(misplaced(program, without(program.effects, effect)), "") << program.name << ' ' << effect.bits;
      }
    }
  }
  EXPECT_GT(looked_for, 80U);
}

// Light at vertices is known by what it shares with colours, texels with alpha by what they share with other fragments.
TEST(FirmwareAbsence, EveryEffectHasANameToBeKnownBy) {
  for (const effects_cost::Comparison& comparison : effects_cost::kComparisons) {
    const bool has_one =
        std::ranges::any_of(kMarkers, [&](const Marker& marker) { return marker.effects.any(comparison.added); });
    EXPECT_TRUE(has_one) << comparison.effect;
  }
}

}  // namespace
}  // namespace effects_test
