// Fixed point to floating point.
#include "bench/peer_programs/peer_scene.hpp"

#include <array>
#include <cstddef>

namespace zstrip::peer {
namespace {

double real(Fixed value) { return static_cast<double>(value) / kFixedOne; }

/// Rows of an affine map: 3 x 4.
using Affine = std::array<std::array<double, 4>, 3>;

Affine camera_from_world(const Camera& camera) {
  constexpr double kUnit = 1 << 30;
  Affine map{};
  const std::array axes{camera.right, camera.up, camera.back};
  for (std::size_t row = 0; row < 3; ++row) {
    const double x = axes[row].x / kUnit, y = axes[row].y / kUnit, z = axes[row].z / kUnit;
    map[row] = {x, y, z, -(x * real(camera.eye.x) + y * real(camera.eye.y) + z * real(camera.eye.z))};
  }
  return map;
}

Affine product(const Affine& a, const Affine& b) {
  Affine result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t k = 0; k < 3; ++k) result[row][column] += a[row][k] * b[k][column];
    }
    result[row][3] += a[row][3];
  }
  return result;
}

std::uint8_t scaled(std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a * b / 255); }

}  // namespace

std::optional<Scene> Scene::open(const std::string& name) {
  Scene scene;
  scene.built_in_ = scenes::find(name);
  if (scene.built_in_ == nullptr || scene.built_in_->scene.instances.size() != 1) return std::nullopt;
  const zstrip::Scene& source = scene.built_in_->scene;
  scene.mesh_ = &source.meshes[source.instances[0].mesh];
  scene.material_ = &source.materials[source.instances[0].material];
  if (scene.material_->lit) return std::nullopt;
  if (scene.material_->texture != kNoTexture) scene.texture_ = &source.textures[scene.material_->texture];

  const Mesh& mesh = *scene.mesh_;
  const Colour base = scene.texture_ != nullptr ? Colour{255, 255, 255, 255} : scene.material_->colour;
  const double uv_scale = 1.0 / (1 << mesh.texcoord_bits);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Position& p = mesh.positions[i];
    const auto along = [](Fixed centre, Fixed half, std::int16_t at) {
      return static_cast<float>(real(centre) + real(half) * at / 32768);
    };
    Vertex vertex{along(mesh.centre.x, mesh.half_extent.x, p.x),
                  along(mesh.centre.y, mesh.half_extent.y, p.y),
                  along(mesh.centre.z, mesh.half_extent.z, p.z),
                  0,
                  0,
                  base.r,
                  base.g,
                  base.b,
                  255};
    if (!mesh.colours.empty()) {
      const Colour& c = mesh.colours[i];
      vertex.r = scaled(c.r, base.r);
      vertex.g = scaled(c.g, base.g);
      vertex.b = scaled(c.b, base.b);
    }
    if (!mesh.texcoords.empty()) {
      vertex.u = static_cast<float>(mesh.texcoords[i].u * uv_scale);
      vertex.v = static_cast<float>(mesh.texcoords[i].v * uv_scale);
    }
    scene.vertices_.push_back(vertex);
  }
  return scene;
}

View Scene::view(std::uint32_t frame, int width, int height) const {
  scenes::Staged staged;
  scenes::stage_workload(*built_in_, staged, frame);
  const Camera& camera = staged.camera;
  Affine world{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      world[row][column] = real(staged.scene.instances[0].transform.m[row][column]);
    }
  }
  const Affine map = product(camera_from_world(camera), world);
  View view{};
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) view.modelview[4 * column + row] = static_cast<float>(map[row][column]);
  }
  view.modelview[15] = 1;
  const double near = real(camera.near_plane), far = real(camera.far_plane), focal = real(camera.focal);
  view.projection[0] = static_cast<float>(focal * height / width);
  view.projection[5] = static_cast<float>(focal);
  view.projection[10] = static_cast<float>((far + near) / (near - far));
  view.projection[11] = -1;
  view.projection[14] = static_cast<float>(2 * far * near / (near - far));
  return view;
}

}  // namespace zstrip::peer
