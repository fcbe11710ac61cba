// No symbol of an effect is linked into a program whose scene lacks it. The programs are compiled without inlining, so
// that every function that is used has a symbol.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include "billboards_scene.hpp"
#include "csg_scene.hpp"
#include "edges_scene.hpp"
#include "lines_scene.hpp"
#include "markers.hpp"
#include "outlines_scene.hpp"
#include "overlay_scene.hpp"
#include "shadows_scene.hpp"
#include "zstrip_scenes/character.hpp"
#include "zstrip_scenes/effect_scenes.hpp"
#include "zstrip_scenes/spheres.hpp"

namespace effects_test {
namespace {

using namespace zstrip;

/// What `nm --demangle` prints.
std::string symbols(const std::string& program) {
  const std::string command = ZSTRIP_NM " --demangle '" + program + "'";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  if (!pipe) return text;
  std::array<char, 4096> part{};
  for (std::size_t read; (read = std::fread(part.data(), 1, part.size(), pipe.get())) != 0;)
    text.append(part.data(), read);
  return text;
}

void expect_only(const std::string& program, const scenes::BuiltIn& built_in, const View& view = {}) {
  SCOPED_TRACE(program);
  Effects effects = effects_of(built_in.scene, built_in.camera) | effects_of(view);
  constexpr Effects kTextured =
      effect::shade_textured | effect::shade_textured_flat | effect::shade_textured_gouraud | effect::shade_fragments;
  if (!effects.has(effect::shade_gouraud)) effects = without(effects, effect::gouraud);  // texels vary: another shade
  if (!effects.any(kTextured)) effects = without(effects, effect::textures);  // those of quadrics are other code
  const std::string linked = symbols(program);
  ASSERT_NE(linked.find("zstrip::detail::draw_strip"), std::string::npos) << "no symbols";
  // All zeros until it begins: a member with another first value would put all of it into flash.
  EXPECT_NE(linked.find(" b (anonymous namespace)::renderer\n"), std::string::npos);
  for (const Marker& marker : kMarkers) {
    EXPECT_EQ(linked.find(marker.symbol) != std::string::npos, effects.any(marker.effects)) << marker.symbol;
  }
}

TEST(EffectsAbsence, ProgramsHoldTheCodeOfTheirScenesEffectsAndNoOther) {
  const std::string folder = ZSTRIP_PIPELINES "/zstrip_pipeline_of_";
  const auto check = [&](const scenes::BuiltIn& built_in) { expect_only(folder + built_in.name, built_in); };
  check(scenes::knot);
  check(scenes::room);
  check(scenes::spheres);
  check(scenes::lines);
  check(scenes::billboards);
  check(scenes::outlines);
  check(scenes::shadows);
  check(scenes::csg);
  check(scenes::edges);
  check(scenes::overlay);
  check(scenes::character);
  for (const scenes::BuiltIn& built_in : scenes::effect_scenes()) check(built_in);
  expect_only(folder + "knot_rgb565_dithered", scenes::knot, {64, 48, PixelFormat::rgb565, true});
  expect_only(folder + "fog_rgb565_dithered", scenes::fog, {64, 48, PixelFormat::rgb565, true});
  expect_only(folder + "knot_mono_dithered", scenes::knot, {64, 48, PixelFormat::mono, true});
  expect_only(folder + "knot_rgb565_4", scenes::knot, {64, 48, PixelFormat::rgb565, false, 4});
  expect_only(folder + "knot_mono_2", scenes::knot, {64, 48, PixelFormat::mono, false, 2});
}

TEST(EffectsAbsence, AFixedRendererWithoutClippingIsOnlyWhatItsFramesNeed) {
  const std::string linked = symbols(ZSTRIP_PIPELINES "/zstrip_fixed_pipeline");
  ASSERT_NE(linked.find("zstrip::detail::draw_fixed_strip"), std::string::npos) << "no symbols";
  EXPECT_NE(linked.find(" b (anonymous namespace)::renderer\n"), std::string::npos) << "no flash for its memory";
  for (const char* other : {
           "clip_perspective",
           "TriangleClipper",
           "RasterPolygon",
           "project_wide",  // clipping
           "EdgeWalk::wide",
           "divide_long",  // edges in 64 bits
           "validate",
           "check_request",
           "check_room",
           "zstrip::effects_of",
           "zstrip::count(",  // checks
           "resolve_mono",
           "resolve_gray4",
           "resolve_wide",
           "convert_pixels",
           "luma(",  // other formats
           "object_light",
           "compile_instance<true",
           "shade_vertices",  // no light, one projection
           "draw_span_triangle<(zstrip::detail::Shade)0",
           "draw_span_triangle<(zstrip::detail::Shade)1",  // other shades
       }) {
    EXPECT_EQ(linked.find(other), std::string::npos) << other;
  }
}

}  // namespace
}  // namespace effects_test
