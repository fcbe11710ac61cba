// [[light]] and [fog] of a scene file.
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "compose/scene_tables.hpp"
#include "compose/table_values.hpp"

namespace zstrip::sim {
namespace {

enum class LightType : std::uint8_t { directional, point, spot };
constexpr std::pair<std::string_view, LightType> kLightTypes[] = {
    {"directional", LightType::directional}, {"point", LightType::point}, {"spot", LightType::spot}};
constexpr std::pair<std::string_view, FogMode> kFogModes[] = {{"linear", FogMode::linear},
                                                              {"exponential", FogMode::exponential},
                                                              {"exponential_squared", FogMode::exponential_squared}};

FileShadow read_shadow(TomlTable& table) {
  FileShadow shadow;
  const std::int64_t size =
      table.integer("size", 1 << kMinShadowLog2, 1 << kMaxShadowLog2).value_or(1 << shadow.log2_size);
  if ((size & (size - 1)) != 0) table.wrong("size", "'size' must be a power of two");
  shadow.log2_size = static_cast<std::uint8_t>(std::countr_zero(static_cast<std::uint64_t>(size)));
  shadow.bias = static_cast<std::uint16_t>(table.integer("bias", 0, 65535).value_or(shadow.bias));
  shadow.slope_bias = table.number("slope_bias", {0, 1000}).value_or(shadow.slope_bias);
  shadow.pool = static_cast<std::uint32_t>(table.integer("pool", 1, 1 << 24).value_or(0));
  table.finish();
  return shadow;
}

}  // namespace

FileLight read_light(TomlTable& table) {
  FileLight light;
  light.line = table.line();
  const LightType type = table.choice("type", kLightTypes).value_or(LightType::directional);
  const bool shines_ahead = type != LightType::point;
  if (shines_ahead != table.has("direction")) {
    table.wrong("direction", shines_ahead ? "'direction' is missing: in which the light shines"
                                          : "a point light shines in every direction");
  }
  light.direction = table.vector("direction", kLength).value_or(light.direction);
  check_direction(table, "direction", light.direction);
  light.colour = table.colour("colour").value_or(light.colour);
  if (type == LightType::directional) {
    const double intensity = table.number("intensity", {0, 1}).value_or(1);
    for (std::uint8_t* channel : {&light.colour.r, &light.colour.g, &light.colour.b}) {
      *channel = static_cast<std::uint8_t>(std::lround(*channel * intensity));
    }
    if (auto shadow = table.table("shadow", "[light.shadow]")) light.shadow = read_shadow(*shadow);
    table.finish();
    return light;
  }
  if (table.has("shadow")) table.wrong("shadow", "only a directional light has a shadow");
  light.punctual = type == LightType::spot ? PunctualLightType::spot : PunctualLightType::point;
  if (!table.has("position")) table.wrong("position", "'position' is missing: where the light is");
  light.position = table.vector("position", kLength).value_or(light.position);
  light.intensity = table.number("intensity", {0, kLength.high}).value_or(1);
  light.range = table.number("range", kPositive).value_or(0);
  if (type == LightType::spot) {
    light.inner = table.number("inner", {0, 89}).value_or(light.inner);
    light.outer = table.number("outer", {1, 90}).value_or(light.outer);
    if (light.outer - light.inner < 0.5)
      table.wrong("outer", "'outer' must be at least half a degree more than 'inner'");
  }
  table.finish();
  return light;
}

FileFog read_fog(TomlTable& table) {
  FileFog fog;
  fog.line = table.line();
  fog.colour = table.colour("colour").value_or(fog.colour);
  fog.mode = table.choice("mode", kFogModes).value_or(FogMode::linear);
  fog.start = table.number("start", {0, kLength.high}).value_or(0);
  fog.end = table.number("end", kPositive).value_or(0);
  fog.density = table.number("density", {0, kLength.high}).value_or(0);
  const bool linear = fog.mode == FogMode::linear;
  if (linear && table.has("density")) table.wrong("density", "'density' goes with the exponential modes");
  if (linear && !table.has("density") && !table.has("end"))
    table.wrong("end", "'end' is missing, the distance where all is fog");
  if (linear && fog.end <= fog.start) table.wrong("end", "'end' must be greater than 'start': all is fog there");
  if (!linear && !table.has("density")) table.wrong("density", "'density' is missing");
  for (const char* key : {"start", "end"}) {
    if (!linear && table.has(key)) table.wrong(key, fmt::format("'{}' goes with mode = \"linear\"", key));
  }
  table.finish();
  return fog;
}

}  // namespace zstrip::sim
