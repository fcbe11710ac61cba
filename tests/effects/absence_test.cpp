// No symbol of an effect is linked into a program whose scene lacks it. The programs are compiled without inlining, so
// that every function that is used has a symbol.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <regex>
#include <string>

#include "zstrip_scenes/effect_scenes.hpp"

namespace effects_test {
namespace {

using namespace zstrip;

/// What `nm --demangle` prints.
std::string symbols(const std::string& program) {
  const std::string command = std::string(ZSTRIP_NM) + " --demangle '" + program + "'";
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
    {effect::fog, R"(zstrip::detail::(fog_curve|visibility|power_of_half|FogPlane<))"},
    {effect::vertex_light, R"(zstrip::detail::locally_lit_colour<)"},
    {effect::local_light, R"(zstrip::detail::(frame_lights|instance_shading|direction_of))"},
    {effect::punctual_lights, R"(zstrip::detail::attenuation)"},
    {effect::specular, R"(zstrip::detail::power\()"},
    {effect::fragments, R"(zstrip::detail::(fill_fragments|shade_fragment|draw_fragment_triangle)<)"},
    {effect::blending, R"(zstrip::Frame::Access::prepare_order)"},
    {effect::bilinear, R"(zstrip::detail::TextureSampler::bilinear)"},
    {effect::textures, R"(zstrip::detail::TextureCoordinates<)"},
    {effect::lighting, R"(zstrip::detail::lit_colour)"},
    {effect::quadrics, R"(zstrip::detail::QuadricFill)"},
    {effect::bins, R"(zstrip::detail::Bins::append)"},
};

void expect_only(const std::string& program, const scenes::BuiltIn& built_in) {
  SCOPED_TRACE(program);
  const Effects effects = effects_of(built_in.scene, built_in.camera);
  const std::string linked = symbols(program);
  ASSERT_NE(linked.find("zstrip::Frame::Access::draw_strip"), std::string::npos) << "no symbols";
  for (const Marker& marker : kMarkers) {
    EXPECT_EQ(std::regex_search(linked, std::regex(marker.symbol)), effects.any(marker.effects)) << marker.symbol;
  }
}

TEST(EffectsAbsence, ProgramsHoldTheCodeOfTheirScenesEffectsAndNoOther) {
  const std::string folder = std::string(ZSTRIP_PIPELINES) + "/zstrip_pipeline_of_";
  const auto check = [&](const scenes::BuiltIn& built_in) { expect_only(folder + built_in.name, built_in); };
  check(scenes::knot);
  check(scenes::room);
  for (const scenes::BuiltIn& built_in : scenes::effect_scenes()) check(built_in);
}

}  // namespace
}  // namespace effects_test
