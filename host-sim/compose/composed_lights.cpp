// Converts the file's lights and fog to the scene's units.
#include "compose/composed_lights.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "import/quantise.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::sim {
namespace {

constexpr double kMaxFixed = 32767;

bool to_fixed_if_it_fits(double value, Fixed& fixed) {
  const bool fits = std::abs(value) <= kMaxFixed;
  if (fits) fixed = to_fixed(value);
  return fits;
}

/// The direction in which the light shines: 1.15, with length `unit`.
struct Direction {
  std::int16_t x = 0, y = 0, z = 0;
};
Direction to_direction(const Vector& v, double unit) {
  const double length = std::hypot(v[0], v[1], v[2]);
  const auto component = [&](std::size_t axis) {
    return static_cast<std::int16_t>(std::lround(unit * v[axis] / length));
  };
  return {component(0), component(1), component(2)};
}

/// Returns false if the light is too far away or too strong for the scene's units.
bool to_punctual(const FileLight& from, double units, PunctualLight& to) {
  to.type = *from.punctual;
  to.colour = from.colour;
  if (!to_fixed_if_it_fits(from.position[0] * units, to.position.x) ||
      !to_fixed_if_it_fits(from.position[1] * units, to.position.y) ||
      !to_fixed_if_it_fits(from.position[2] * units, to.position.z) ||
      !to_fixed_if_it_fits(from.intensity * units * units, to.intensity) ||
      !to_fixed_if_it_fits(from.range * units, to.range)) {
    return false;
  }
  const auto cosine = [](double degrees) {
    return static_cast<std::int16_t>(std::lround(32767 * std::cos(degrees * std::numbers::pi / 180)));  // 1.15
  };
  const Direction ahead = to_direction(from.direction, 32767);
  to.x = ahead.x, to.y = ahead.y, to.z = ahead.z;
  to.cosine_inner = cosine(from.inner), to.cosine_outer = cosine(from.outer);
  if (to.cosine_inner <= to.cosine_outer) to.cosine_inner = static_cast<std::int16_t>(to.cosine_outer + 1);
  return true;
}

}  // namespace

Result<Done> add_lights(const SceneFile& file, ComposedScene& scene) {
  for (const FileLight& light : file.lights) {
    if (light.shadow) {
      if (scene.shadow) {
        return at_line(file.path, light.line, "[[light]] has a 'shadow', which another light has already: one may");
      }
      scene.shadow = Shadow{.light = static_cast<std::uint8_t>(scene.lights.size()),
                            .log2_size = light.shadow->log2_size,
                            .bias = light.shadow->bias,
                            .slope_bias = to_fixed(light.shadow->slope_bias),
                            .pool = light.shadow->pool};
      scene.shadow_origin = origin_of(file.path, light.line);
    }
    if (!light.punctual) {
      const Direction towards = to_direction(light.direction, -32767);
      scene.lights.push_back({towards.x, towards.y, towards.z, light.colour});
      continue;
    }
    PunctualLight punctual;
    if (!to_punctual(light, scene.units.scale, punctual)) {
      return at_line(file.path, light.line, "[[light]] is too far away or too strong for this scene");
    }
    scene.punctual_lights.push_back(punctual);
  }
  if (file.lights.empty()) scene.lights.assign(std::begin(scenes::kKeyLight), std::end(scenes::kKeyLight));
  scene.ambient = file.ambient.value_or(scenes::kAmbient);
  scene.background = file.background.value_or(Colour{0, 0, 0, 255});
  return Done{};
}

Result<Done> add_fog(const SceneFile& file, ComposedScene& scene) {
  if (!file.fog) return Done{};
  const FileFog& from = *file.fog;
  const double units = scene.units.scale;
  Fog fog{.colour = from.colour, .mode = from.mode};
  const double end = from.end * units, density = from.density / units;
  if (!(end <= kMaxFixed && density <= kMaxFixed)) {
    return at_line(file.path, from.line, "[fog]: the lengths are too great for this scene");
  }
  if (from.mode == FogMode::linear) {
    fog.start = to_fixed(from.start * units);
    fog.end = std::max(to_fixed(end), fog.start + 1);
  } else {
    fog.density = to_fixed(density);
  }
  scene.fog = fog;
  scene.fog_origin = origin_of(file.path, from.line);
  return Done{};
}

}  // namespace zstrip::sim
