// Smooth metals mirror a studio: the renderer has no metal, but environment maps.
#include "import/metals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "import/screen_channel.hpp"

namespace zstrip::sim {
namespace {

/// Unit vectors along the camera's axes: to the right, up, towards the viewer.
using Direction = std::array<double, 3>;

/// Returns the cosine of the angle between unit vectors.
double cosine(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Direction along(const Direction& v) {
  const double length = std::sqrt(cosine(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

constexpr std::array<std::uint8_t, 3> kUntinted{255, 255, 255};

/// Rises from 0 to 1 between two values.
double rise(double value, double from, double to) {
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A round lamp with soft borders.
struct Lamp {
  Direction towards;
  double inner, outer;  ///< cosines of the angles from its middle at which it begins to fade, and ends
  double radiance;
};

/// Returns the linear radiance that arrives from a direction; 1 is a white wall in full light.
double studio(const Direction& from) {
  static const std::array<Lamp, 4> lamps{{{along({0.0, 0.95, 0.3}), 0.975, 0.94, 4.0},
                                          {along({0.05, 0.5, 0.86}), 0.985, 0.965, 4.0},
                                          {along({-0.75, 0.7, 0.4}), 0.98, 0.955, 4.0},
                                          {along({0.8, 0.7, 0.3}), 0.98, 0.955, 4.0}}};
  constexpr double kFloor = 0.7, kWall = 0.15;
  const double towards_viewer = std::max(from[2], 0.0);
  double sum = kFloor + (kWall - kFloor) * rise(from[1], -0.25, 0.1);
  sum += 0.5 * rise(from[1], 0.1, 1);  // the ceiling
  sum += 0.22 * towards_viewer * towards_viewer;
  for (const Lamp& lamp : lamps) sum += lamp.radiance * rise(cosine(from, lamp.towards), lamp.outer, lamp.inner);
  return sum;
}

struct Sample {
  Direction from;
  double radiance;
};

/// Returns directions that are spread evenly over the sphere, on a spiral.
std::vector<Sample> studio_samples() {
  constexpr int kSamples = 4096;
  std::vector<Sample> samples;
  samples.reserve(kSamples);
  for (int i = 0; i < kSamples; ++i) {
    const double y = 1 - (2 * i + 1) / double{kSamples}, radius = std::sqrt(1 - y * y);
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const Direction from{radius * std::cos(angle), y, radius * std::sin(angle)};
    samples.push_back({from, studio(from)});
  }
  return samples;
}

/// Returns the direction that the texel's middle mirrors: docs/conventions.md has the formula of sphere maps.
Direction mirrored(std::uint32_t column, std::uint32_t row) {
  const auto from_middle = [](std::uint32_t texel) { return (2.0 * texel + 1 - kStudioSide) / (kStudioSide - 1.0); };
  double x = from_middle(column), y = -from_middle(row);
  const double radius = std::max(std::hypot(x, y), 1.0);
  x /= radius, y /= radius;
  const double z = std::sqrt(std::max(1 - x * x - y * y, 0.0));
  return {2 * z * x, 2 * z * y, 2 * z * z - 1};
}

/// Blinn-Phong's lobe about the half vector is four times as sharp as one about the mirrored direction.
unsigned exponent_of(double roughness) {
  const double alpha = std::max(roughness * roughness, 1e-3);
  const double exponent = (2 / (alpha * alpha) - 2) / 4;
  if (exponent < 4) return 2;
  if (exponent < 16) return 8;
  return exponent < 64 ? 32 : 128;
}

bool is_mirror(const SourceMaterial& material) {
  return material.lit && material.metallic >= kMinMetal && material.roughness <= kMaxMirrorRoughness &&
         material.texture == kNoSourceTexture && material.emissive == std::array<std::uint8_t, 3>{} &&
         material.alpha_mode == AlphaMode::opaque;
}

}  // namespace

RgbImage studio_map(unsigned exponent, const std::array<std::uint8_t, 3>& colour) {
  static const std::vector<Sample> samples = studio_samples();
  RgbImage map{kStudioSide, kStudioSide, {}};
  for (std::uint32_t row = 0; row < kStudioSide; ++row) {
    for (std::uint32_t column = 0; column < kStudioSide; ++column) {
      const Direction towards = mirrored(column, row);
      double sum = 0, weights = 0;
      for (const Sample& sample : samples) {
        double weight = cosine(sample.from, towards);
        if (weight <= 0) continue;
        for (unsigned power = 1; power < exponent; power *= 2) weight *= weight;
        sum += weight * sample.radiance;
        weights += weight;
      }
      for (const std::uint8_t channel : colour) {
        map.rgb.push_back(to_screen_channel(from_screen_channel(channel) * sum / weights, true));
      }
    }
  }
  return map;
}

void show_metals(SourceModel& model) {
  const bool has_lights = !model.lights.empty();
  std::map<std::pair<unsigned, std::array<std::uint8_t, 3>>, std::uint32_t>
      maps;                                                         // texture of an exponent and a colour
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> mirrors;  // material of a file's material, lit or not
  for (SourceMesh& mesh : model.meshes) {
    if (!is_mirror(model.materials[mesh.material])) continue;
    const bool lit = has_lights || mesh.has_colours;
    const auto [mirror, is_new] =
        mirrors.try_emplace({mesh.material, lit}, static_cast<std::uint32_t>(model.materials.size()));
    if (is_new) {
      SourceMaterial shown = model.materials[mesh.material];
      const std::pair kind(exponent_of(shown.roughness), lit ? kUntinted : shown.colour);
      const auto [map, is_first] = maps.try_emplace(kind, static_cast<std::uint32_t>(model.textures.size()));
      if (is_first) {
        model.textures.push_back(studio_map(kind.first, kind.second));
        model.texture_names.emplace_back("the studio that metals mirror");
      }
      shown.texture = map->second;
      shown.is_mirror = true;
      shown.lit = lit;
      if (lit && !has_lights) {  // emission is multiplied with vertex colours, but not with light
        shown.emissive = shown.colour;
        shown.colour = {};
      }
      shown.specular = {};
      model.materials.push_back(std::move(shown));
    }
    mesh.material = mirror->second;
    mesh.has_texcoords = false;
    for (SourceVertex& vertex : mesh.vertices) vertex.texcoord = {};
  }
}

}  // namespace zstrip::sim
