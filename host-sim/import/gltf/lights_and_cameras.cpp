// The lights and cameras of a glTF file's scene.
#include "import/gltf/lights_and_cameras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "text/number.hpp"

namespace zstrip::sim {
namespace {

/// Returns the rotated direction, with length 1; zero if there is none.
Vector turned(const Affine& by, const Vector& direction) {
  Affine linear = by;
  for (auto& row : linear.m) row[3] = 0;
  const Vector v = linear * direction;
  const double length = std::hypot(v[0], v[1], v[2]);
  if (!std::isfinite(length) || !(length > 1e-20)) return {};
  return {v[0] / length, v[1] / length, v[2] / length};
}

Vector origin_of(const Affine& a) { return {a.m[0][3], a.m[1][3], a.m[2][3]}; }

bool is_place(const Vector& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

std::optional<SourceLightType> type_of_light(const GltfJson& light) {
  const std::string type = text_in(light, "type");
  if (type == "directional") return SourceLightType::directional;
  if (type == "point") return SourceLightType::point;
  if (type == "spot") return SourceLightType::spot;
  return std::nullopt;
}

}  // namespace

void read_gltf_lights(const GltfJson& json, const GltfNodes& nodes, SourceModel& model) {
  const GltfJson& lights = member(extension(json, "KHR_lights_punctual"), "lights");
  std::size_t others = 0;
  for (const std::size_t node : nodes.in_scene()) {
    const std::optional<std::size_t> index =
        index_in(extension(element(member(json, "nodes"), node), "KHR_lights_punctual"), "light");
    if (!index || !nodes.is_visible(node)) continue;
    const GltfJson& light = element(lights, *index);
    const std::optional<SourceLightType> type = type_of_light(light);
    if (!type) {
      ++others;
      continue;
    }
    const Affine& world = nodes.world(node);
    SourceLight read{.type = *type,
                     .towards = turned(world, {0, 0, 1}),
                     .colour = numbers_in<3>(light, "color", {1, 1, 1}),
                     .position = origin_of(world),
                     .range = std::max(number_in(light, "range", 0), 0.0)};
    const double intensity = number_in(light, "intensity", 1);
    for (double& channel : read.colour) channel = std::max(channel * intensity, 0.0);
    if (!is_place(read.colour) || *std::ranges::max_element(read.colour) == 0) continue;
    if (*type != SourceLightType::point && read.towards == Vector{}) continue;
    if (*type != SourceLightType::directional && !is_place(read.position)) continue;
    if (*type == SourceLightType::spot) {
      const GltfJson& spot = member(light, "spot");
      read.outer = std::clamp(number_in(spot, "outerConeAngle", std::numbers::pi / 4), 0.0, std::numbers::pi / 2);
      read.inner = std::clamp(number_in(spot, "innerConeAngle", 0), 0.0, read.outer);
    }
    model.lights.push_back(read);
  }
  if (others > 0) {
    model.warnings.push_back(
        fmt::format("{} left out: only directional lights, point and spot lights are drawn", counted(others, "light")));
  }
}

void read_gltf_cameras(const GltfJson& json, const GltfNodes& nodes, SourceModel& model) {
  std::size_t others = 0;
  for (const std::size_t node : nodes.in_scene()) {
    const GltfJson& from = element(member(json, "nodes"), node);
    const std::optional<std::size_t> index = index_in(from, "camera");
    if (!index) continue;
    const GltfJson& camera = element(member(json, "cameras"), *index);
    const std::string type = text_in(camera, "type");
    if (type != "perspective" && type != "orthographic") {
      ++others;
      continue;
    }
    const Affine& world = nodes.world(node);
    SourceCamera read{.name = text_in(from, "name"),
                      .other_name = text_in(camera, "name"),
                      .eye = origin_of(world),
                      .towards = turned(world, {0, 0, -1}),
                      .up = turned(world, {0, 1, 0})};
    if (read.name.empty()) std::swap(read.name, read.other_name);
    if (read.name.empty()) read.name = fmt::format("nodes[{}]", node);
    if (!is_place(read.eye) || read.towards == Vector{}) continue;
    read.orthographic = type == "orthographic";
    if (read.orthographic) {
      read.half_height = std::abs(number_in(member(camera, "orthographic"), "ymag", 1));
      if (!(read.half_height > 0)) continue;
    } else {
      const double angle = number_in(member(camera, "perspective"), "yfov", std::numbers::pi / 4);
      read.field_of_view = angle * 180 / std::numbers::pi;
      read.near = number_in(member(camera, "perspective"), "znear", 0);
    }
    model.cameras.push_back(read);
  }
  if (others > 0) {
    model.warnings.push_back(fmt::format("{} left out: neither perspective nor orthographic, or not in the file",
                                         counted(others, "camera")));
  }
}

}  // namespace zstrip::sim
