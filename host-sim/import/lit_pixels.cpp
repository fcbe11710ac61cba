// Finds materials for which light at vertices would be wrong: large triangles close to a lamp.
#include "import/lit_pixels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "import/quantise.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {
namespace {

struct Lit {
  Vector place, normal;
};

/// Returns the light that arrives, of the brightest channel, as zstrip/scene.hpp defines PunctualLight.
double arriving(const PunctualLight& light, const Lit& at) {
  const Vector from{from_fixed(light.position.x), from_fixed(light.position.y), from_fixed(light.position.z)};
  const Vector towards{from[0] - at.place[0], from[1] - at.place[1], from[2] - at.place[2]};
  const double squared = std::max(scalar_product(towards, towards), 1e-12), distance = std::sqrt(squared);
  double share = std::min(from_fixed(light.intensity) / squared, 256.0);
  if (light.range > 0) {
    const double ratio = squared / (from_fixed(light.range) * from_fixed(light.range));
    share *= std::max(0.0, 1 - ratio * ratio);
  }
  if (light.type == PunctualLightType::spot) {
    const Vector axis{light.x / 32767.0, light.y / 32767.0, light.z / 32767.0};
    const double inner = light.cosine_inner / 32767.0, outer = light.cosine_outer / 32767.0;
    const double cone = std::clamp((-scalar_product(axis, towards) / distance - outer) / (inner - outer), 0.0, 1.0);
    share *= cone * cone;
  }
  return share * std::max(0.0, scalar_product(at.normal, towards) / distance);
}

double brightness(const Model& model, const Lit& at) {
  double sum = 0;
  for (const PunctualLight& light : model.punctual_lights) sum += arriving(light, at);
  return std::min(sum, 1.0);
}

Lit vertex_of(const Mesh& mesh, std::uint16_t index) {
  const Position& p = mesh.positions[index];
  const Normal& n = mesh.normals[index];
  const auto place = [](Fixed centre, Fixed half, std::int16_t steps) {
    return from_fixed(centre) + from_fixed(half) * steps / 32768;  // 1.15 of the half extent
  };
  return {{place(mesh.centre.x, mesh.half_extent.x, p.x), place(mesh.centre.y, mesh.half_extent.y, p.y),
           place(mesh.centre.z, mesh.half_extent.z, p.z)},
          {n.x / 127.0, n.y / 127.0, n.z / 127.0}};
}

/// Interpolates between the corners, with their weights.
Lit between(const std::array<Lit, 3>& corners, const Vector& shares) {
  Lit at{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at.place[axis] += shares[k] * corners[k].place[axis];
      at.normal[axis] += shares[k] * corners[k].normal[axis];
    }
  }
  const double length = std::sqrt(scalar_product(at.normal, at.normal));
  for (double& component : at.normal) component /= std::max(length, 1e-12);
  return at;
}

bool is_wrong_at_vertices(const Model& model, const Mesh& mesh) {
  constexpr std::array<Vector, 4> kLooks{{{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};
  return std::ranges::any_of(mesh.triangles, [&](const Triangle& triangle) {
    const std::array<Lit, 3> corners{vertex_of(mesh, triangle.a), vertex_of(mesh, triangle.b),
                                     vertex_of(mesh, triangle.c)};
    Vector lit{};
    for (std::size_t k = 0; k < 3; ++k) lit[k] = brightness(model, corners[k]);
    return std::ranges::any_of(kLooks, [&](const Vector& shares) {
      return std::abs(brightness(model, between(corners, shares)) - scalar_product(shares, lit)) > kMaxLightError;
    });
  });
}

}  // namespace

void light_at_pixels(Model& model) {
  if (model.punctual_lights.empty()) return;
  for (const Instance& instance : model.instances) {
    Material& material = model.materials[instance.material];
    const Mesh& mesh = model.meshes[instance.mesh];
    if (!material.lit || material.smooth != Shading::gouraud || mesh.normals.empty()) continue;
    if (is_wrong_at_vertices(model, mesh)) material.smooth = Shading::pixel;
  }
}

}  // namespace zstrip::sim
