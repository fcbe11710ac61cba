// A plan has bytes for a purpose only if the scene has what the purpose is for, and then as many as it says.
#include "billboards_scene.hpp"
#include "drawn.hpp"
#include "lines_scene.hpp"
#include "outlines_scene.hpp"
#include "zstrip_scenes/cube.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/spheres.hpp"

namespace effects_test::plan_test {
namespace {

constexpr View kView{64, 48, PixelFormat::rgb565};

/// What docs/effects.md says: the block's head, fog, a place in the order for each instance, light, turned
/// instances, what mirrors, in whole words of 8 bytes the scene with outlines.
std::uint32_t bytes_of_effects(Effects effects, std::uint32_t instances) {
  std::uint32_t bytes = 0;
  if (effects.has(effect::fog)) bytes += 40;
  if (effects.has(effect::blending)) bytes += 16 * instances;
  if (effects.any(effect::local_light)) bytes += 192 + 68 * instances;
  if (effects.any(effect::billboards | effect::outlines)) bytes += 52 * instances;
  if (effects.has(effect::environment)) bytes += 8 + 68 * instances;
  if (effects.has(effect::outlines)) bytes = (bytes + 7) / 8 * 8 + 232;
  return bytes == 0 ? 0 : (bytes + 16 + 7) / 8 * 8;
}

void expect_only_its_purposes(const scenes::BuiltIn& built_in) {
  SCOPED_TRACE(built_in.name);
  const Effects effects = effects_of(built_in.scene, built_in.camera);
  const Plan whole = plan(built_in.counts, kView, effects, {.strip_rows = kView.height}).plan;
  EXPECT_EQ(whole.effect_bytes, bytes_of_effects(effects, built_in.counts.instances));
  EXPECT_EQ(whole.extent_bytes, 0U) << "one strip needs to know of no other";
  EXPECT_EQ(whole.colour_bytes, 0U) << "drawn in place";
  EXPECT_EQ(whole.bin_bytes, 0U);
  EXPECT_EQ(whole.visibility_bytes, 0U);
  SceneCounts fewer = built_in.counts;
  fewer.quadrics = 0;
  const Effects others = without(effects, effect::quadrics);
  const Plan no_quadrics = plan(fewer, kView, others, {.strip_rows = kView.height}).plan;
  EXPECT_EQ(whole.instance_bytes - no_quadrics.instance_bytes, 384 * built_in.counts.quadrics);
  EXPECT_EQ(whole.instance_bytes,
            160 * built_in.counts.instances + 384 * built_in.counts.quadrics + 176 * built_in.counts.line_sets);

  // Each of the others comes with what it is for.
  EXPECT_GT(plan(built_in.counts, kView, effects, {.strip_rows = 8}).plan.extent_bytes, 0U);
  EXPECT_GT(plan(built_in.counts, {64, 48, PixelFormat::mono}, effects).plan.colour_bytes, 0U);
  const Budget binned{.strip_rows = 8, .modes = Modes::binned};
  EXPECT_GT(plan(built_in.counts, kView, effects | effect::bins, binned).plan.bin_bytes, 0U);
}

TEST(EffectsPlan, OnlyWhatTheSceneHas) {
  expect_only_its_purposes(scenes::knot);
  expect_only_its_purposes(scenes::room);
  expect_only_its_purposes(scenes::spheres);
  expect_only_its_purposes(scenes::lines);
  expect_only_its_purposes(scenes::billboards);
  expect_only_its_purposes(scenes::outlines);
  for (const scenes::BuiltIn& built_in : scenes::effect_scenes()) expect_only_its_purposes(built_in);
}

TEST(EffectsPlan, AShadowPoolWhoseSumWrappedIn32BitsIsRefused) {
  const SceneCounts counts{.instances = 1,
                           .triangles = 12,
                           .vertices = 24,
                           .largest_meshlet = 24,
                           .meshlets = 1,
                           .longest_meshlet = 12,
                           .shadow_side = 64,
                           .shadow_pool = 0xFFFFF5A0};
  const PlanResult result = plan(counts, kView, effect::lighting | effect::shadows);
  EXPECT_EQ(result.status.error, Error::arena_too_small);
  EXPECT_EQ(result.status.purpose, Purpose::effects);
}

TEST(EffectsPlan, EightBytesForEffectsHadAHeadOfSixteenWrittenIntoThem) {
  constexpr Effects kCube = effects_of(scenes::cube.scene, scenes::cube.camera);
  Plan plan = zstrip::plan(scenes::cube.counts, kView, kCube).plan;
  plan.effect_bytes = 8;
  constexpr std::uint64_t kBehind = 0x5A5A5A5A5A5A5A5A;
  std::vector<std::uint64_t> arena(plan.bytes() / 8 + 1, kBehind);
  Renderer<kCube | effect::fog> renderer;
  ASSERT_TRUE(renderer.begin_frame(scenes::cube.scene, scenes::cube.camera, kView, plan,
                                   std::as_writable_bytes(std::span(arena)).first(plan.bytes())));
  EXPECT_EQ(arena.back(), kBehind);
}

}  // namespace
}  // namespace effects_test::plan_test
