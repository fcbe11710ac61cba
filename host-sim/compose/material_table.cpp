// [[material]] of a scene file.
#include <cmath>

#include "compose/scene_tables.hpp"

namespace zstrip::sim {
namespace {

constexpr std::pair<std::string_view, AlphaMode> kAlphaModes[] = {
    {"opaque", AlphaMode::opaque}, {"mask", AlphaMode::mask}, {"blend", AlphaMode::blend}};
constexpr std::pair<std::string_view, TextureFilter> kFilters[] = {{"nearest", TextureFilter::nearest},
                                                                   {"bilinear", TextureFilter::bilinear}};
constexpr std::pair<std::string_view, Shading> kShadings[] = {
    {"flat", Shading::flat}, {"gouraud", Shading::gouraud}, {"pixel", Shading::pixel}};
constexpr std::pair<std::string_view, DepthTest> kDepthTests[] = {{"never", DepthTest::never},
                                                                  {"nearer", DepthTest::nearer},
                                                                  {"equal", DepthTest::equal},
                                                                  {"farther", DepthTest::farther},
                                                                  {"not_equal", DepthTest::not_equal},
                                                                  {"always", DepthTest::always},
                                                                  {"nearer_or_equal", DepthTest::nearer_or_equal},
                                                                  {"farther_or_equal", DepthTest::farther_or_equal}};

}  // namespace

FileMaterial read_material(TomlTable& table) {
  FileMaterial material;
  material.line = table.line();
  material.name = table.needed_text("name", "'name' is missing; instances refer to it");
  material.colour = table.colour("colour");
  if (const auto texture = table.text("texture")) material.texture = *texture;
  material.texture_line = table.line_of("texture");
  if (const auto environment = table.text("environment")) {
    if (material.texture) {
      table.wrong("environment",
                  "'environment' is in the place of 'texture', and the material has both; leave out one");
    }
    material.texture = *environment;
    material.mirrors = true;
    material.texture_line = table.line_of("environment");
  }
  if (const auto bits = table.integer("palette", 4, 8)) {
    if (*bits != 4 && *bits != 8) table.wrong("palette", "'palette' must be 4 or 8, the bits of a texel's index");
    if (!material.texture)
      table.wrong("palette", "'palette' is for the colours of 'texture' or 'environment', which is missing");
    material.palette = *bits == 4 ? TextureFormat::palette4 : TextureFormat::palette8;
  }
  material.mipmaps = table.flag("mipmaps");
  material.mipmaps_line = table.line_of("mipmaps");
  material.lit = table.flag("lit");
  material.smooth = table.choice("shading", kShadings);
  if (const auto smooth = table.flag("smooth")) {
    if (material.smooth) {
      table.wrong("smooth", "'smooth' and 'shading' are one property, and the material has both; leave out 'smooth'");
    }
    material.smooth = *smooth;
  }
  material.double_sided = table.flag("double_sided");
  material.emissive = table.colour("emissive");
  material.specular = table.colour("specular");
  if (const auto shininess = table.integer("shininess", 0, 255)) {
    material.shininess = static_cast<std::uint8_t>(*shininess);
  }
  const auto share = [&table](const char* key) -> std::optional<std::uint8_t> {
    const auto value = table.number(key, {0, 1});
    return value ? std::optional(static_cast<std::uint8_t>(std::lround(255 * *value))) : std::nullopt;
  };
  material.alpha = share("alpha");
  material.alpha_mode = table.choice("alpha_mode", kAlphaModes);
  material.alpha_cutoff = share("alpha_cutoff");
  material.filter = table.choice("filter", kFilters);
  material.depth_test = table.choice("depth_test", kDepthTests);
  material.depth_write = table.flag("depth_write");
  if (const auto bias = table.integer("depth_bias", -65535, 65535)) {
    material.depth_bias = static_cast<std::int32_t>(*bias);
  }
  for (const char* key : {"depth_bias", "depth_write", "depth_test"}) {
    if (table.has(key)) material.depth_line = table.line_of(key);
  }
  table.finish();
  return material;
}

}  // namespace zstrip::sim
