// Converts a file's lights to fixed point.
#include "import/fixed_lights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "import/quantise.hpp"
#include "text/number.hpp"

namespace zstrip::sim {
namespace {

/// A light, and its position in the scene's units.
struct Placed {
  SourceLight light;
  std::array<double, 3> at{};
  double strength = 0;  ///< of its brightest channel, at the model
};

double brightest_channel(const SourceLight& light) {
  return *std::max_element(light.colour.begin(), light.colour.end());
}

Placed place(const SourceLight& light, const Units& units) {
  Placed placed{.light = light, .at = {}, .strength = brightest_channel(light)};
  if (light.type == SourceLightType::directional) return placed;
  constexpr double kNearest = 0.5;  // of the model's half size, which is 1
  for (std::size_t i = 0; i < 3; ++i) placed.at[i] = (light.position[i] - units.origin[i]) * units.scale;
  const double distance = std::max(std::hypot(placed.at[0], placed.at[1], placed.at[2]), kNearest) / units.scale;
  placed.strength /= distance * distance;
  return placed;
}

std::int16_t component(double value) {
  return static_cast<std::int16_t>(std::lround(32767 * std::clamp(value, -1.0, 1.0)));  // 1.15
}

Colour colour_of(const SourceLight& light, double full) {
  const auto channel = [&](std::size_t i) {
    return static_cast<std::uint8_t>(std::lround(255 * light.colour[i] / full));
  };
  return {channel(0), channel(1), channel(2), 255};
}

/// Returns nothing if a number is out of the renderer's range, or if the light becomes 0.
std::optional<PunctualLight> to_punctual(const Placed& placed, const Units& units, double exposure) {
  const SourceLight& light = placed.light;
  constexpr double kMax = 32767;  // 16.16
  const double intensity = brightest_channel(light) * units.scale * units.scale / exposure;
  const bool far = std::any_of(placed.at.begin(), placed.at.end(), [](double c) { return !(std::abs(c) <= kMax); });
  if (far || !(intensity <= kMax) || to_fixed(intensity) == 0) return std::nullopt;
  PunctualLight to{.colour = colour_of(light, brightest_channel(light)),
                   .position = {to_fixed(placed.at[0]), to_fixed(placed.at[1]), to_fixed(placed.at[2])},
                   .intensity = to_fixed(intensity)};
  const double range = light.range * units.scale;
  if (range > 0 && range <= kMax) to.range = std::max<Fixed>(to_fixed(range), 1);
  if (light.type == SourceLightType::point) return to;
  to.type = PunctualLightType::spot;
  to.x = component(-light.towards[0]), to.y = component(-light.towards[1]), to.z = component(-light.towards[2]);
  to.cosine_outer = std::clamp<std::int16_t>(component(std::cos(light.outer)), 0, 32766);
  to.cosine_inner =
      std::max<std::int16_t>(component(std::cos(light.inner)), static_cast<std::int16_t>(to.cosine_outer + 1));
  return to;
}

}  // namespace

void set_lights(const std::vector<SourceLight>& lights, const Units& units, Model& model) {
  std::vector<Placed> placed;
  for (const SourceLight& light : lights) placed.push_back(place(light, units));
  std::stable_sort(placed.begin(), placed.end(),
                   [](const Placed& a, const Placed& b) { return a.strength > b.strength; });
  std::size_t beyond = 0, unusable = 0;
  for (const Placed& each : placed) {
    const double exposure = placed.front().strength;
    if (each.light.type == SourceLightType::directional) {
      if (model.lights.size() >= kMaxLights) {
        ++beyond;
        continue;
      }
      const auto& towards = each.light.towards;
      model.lights.push_back(
          {component(towards[0]), component(towards[1]), component(towards[2]), colour_of(each.light, exposure)});
      continue;
    }
    const std::optional<PunctualLight> light = to_punctual(each, units, exposure);
    const bool room = model.punctual_lights.size() < kMaxPunctualLights;
    if (light && room) model.punctual_lights.push_back(*light);
    if (light && !room) ++beyond;
    if (!light) ++unusable;
  }
  if (beyond > 0) {
    model.warnings.push_back(
        fmt::format("{} left out: only the brightest 4 directional ones and the brightest 4 others are drawn",
                    counted(beyond, "light")));
  }
  if (unusable > 0) {
    model.warnings.push_back(fmt::format("{} left out: too far away or too dim", counted(unusable, "light")));
  }
}

}  // namespace zstrip::sim
