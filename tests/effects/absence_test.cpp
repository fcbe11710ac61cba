// No symbol of an effect is linked into a program whose scene lacks it. The programs are compiled without inlining, so
// that every function that is used has a symbol.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include "billboards_scene.hpp"
#include "csg_scene.hpp"
#include "lines_scene.hpp"
#include "outlines_scene.hpp"
#include "shadows_scene.hpp"
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

struct Marker {
  Effects effects;  ///< with any of them the symbol must be there, without all of them it must not
  const char* symbol;
};
constexpr Marker kMarkers[] = {
    {effect::fog, "zstrip::detail::fog_curve("},
    {effect::fog, "zstrip::detail::visibility("},
    {effect::fog, "zstrip::detail::power_of_half("},
    {effect::fog, "zstrip::detail::FogPlane<"},
    {effect::vertex_light, "zstrip::detail::locally_lit_colour<"},
    {effect::local_light, "zstrip::detail::frame_lights("},
    {effect::local_light, "zstrip::detail::instance_shading("},
    {effect::local_light | effect::environment, "zstrip::detail::direction_of("},
    {effect::punctual_lights, "zstrip::detail::attenuation("},
    {effect::specular, "zstrip::detail::power("},
    {effect::fragments, "zstrip::detail::fill_fragments<"},
    {effect::fragments, "zstrip::detail::shade_fragment<"},
    {effect::fragments, "draw_fragment_triangle"},  // whose name binutils cannot demangle
    {effect::blending, "zstrip::Frame::Access::EffectStage::prepare_order("},
    {effect::bilinear, "zstrip::detail::TextureSampler<false, false>::bilinear<"},
    {effect::texture_palettes, "zstrip::detail::TextureSampler<true, false>::"},
    {effect::mipmaps, "zstrip::detail::TextureSampler<false, true>::"},
    {effect::mipmaps, "zstrip::detail::level_of_run("},
    {effect::mipmaps, "::footprint_at("},
    {effect::textures, "zstrip::detail::TextureCoordinates<"},
    {effect::lighting, "zstrip::detail::lit_colour("},
    {effect::quadrics, "zstrip::detail::QuadricFill<"},
    {effect::lines, "zstrip::detail::LineFill<"},
    {effect::lines, "zstrip::detail::clip_segment<"},
    {effect::lines, "zstrip::Frame::Access::prepare_lines("},
    {effect::billboards, "zstrip::Frame::Access::turn_billboards("},
    {effect::billboards, "zstrip::detail::turned_to_viewer("},
    {effect::environment, "zstrip::Frame::Access::EffectStage::prepare_reflections("},
    {effect::environment, "zstrip::detail::eye_forms("},
    {effect::environment, "zstrip::detail::MirroredPoint"},
    {effect::pixel_shading, "zstrip::Frame::Access::EffectStage::prepare_pixel_shading("},
    {effect::pixel_shading, "zstrip::detail::PixelLight<"},
    {effect::pixel_shading, "zstrip::detail::lit_corner<"},
    {effect::pixel_shading, "zstrip::detail::pixel_direction_of("},
    {effect::outlines, "zstrip::Frame::Access::add_hulls("},
    {effect::outlines, "zstrip::detail::make_outline("},
    {effect::outlines, "zstrip::detail::transform_hull<"},
    {effect::shadows, "zstrip::Frame::Access::Shadows::"},
    {effect::shadows, "zstrip::detail::light_camera("},
    {effect::shadows, "zstrip::detail::shadow_place("},
    {effect::shadows, "zstrip::detail::TileStore::"},
    {effect::csg, "zstrip::Frame::Access::Csg::"},
    {effect::csg, "zstrip::detail::DepthMode{(zstrip::DepthFormat)0, false, (zstrip::detail::DepthUse)3"},
    {effect::bins, "zstrip::detail::Bins::append("},
    {effect::dithered_colours, "zstrip::detail::dithered_rgb565("},
    {effect::dithered_colours | effect::dithered_format, "zstrip::detail::kBayer"},
    {effect::dithered_format, "zstrip::dither_pixels("},
    {effect::supersampled, "zstrip::Frame::Access::Samples::"},
    {effect::supersampled, "zstrip::detail::average_samples<false>("},
    {effect::supersampled, "zstrip::detail::camera_of_samples("},
};

void expect_only(const std::string& program, const scenes::BuiltIn& built_in, const View& view = {}) {
  SCOPED_TRACE(program);
  const Effects effects = effects_of(built_in.scene, built_in.camera) | effects_of(view);
  const std::string linked = symbols(program);
  ASSERT_NE(linked.find("zstrip::Frame::Access::draw_strip"), std::string::npos) << "no symbols";
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
  for (const scenes::BuiltIn& built_in : scenes::effect_scenes()) check(built_in);
  expect_only(folder + "knot_rgb565_dithered", scenes::knot, {64, 48, PixelFormat::rgb565, true});
  expect_only(folder + "fog_rgb565_dithered", scenes::fog, {64, 48, PixelFormat::rgb565, true});
  expect_only(folder + "knot_mono_dithered", scenes::knot, {64, 48, PixelFormat::mono, true});
  expect_only(folder + "knot_rgb565_4", scenes::knot, {64, 48, PixelFormat::rgb565, false, 4});
  expect_only(folder + "knot_mono_2", scenes::knot, {64, 48, PixelFormat::mono, false, 2});
}

}  // namespace
}  // namespace effects_test
