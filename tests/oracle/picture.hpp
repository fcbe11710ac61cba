// Whole pictures through the public interface, from a model that a test makes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "draw.hpp"
#include "zstrip/zstrip.hpp"

namespace picture {

/// One mesh, material and instance that own their memory.
struct Model {
  std::vector<Position> positions;
  std::vector<Colour> colours;
  std::vector<Normal> normals;
  std::vector<TexCoord> texcoords;
  std::vector<Triangle> triangles;
  std::vector<std::uint16_t> texels;
  Mesh mesh;
  Texture texture;
  Material material;
  Instance instance;
  DirectionalLight light;

  Scene scene() {
    mesh.positions = positions;
    mesh.colours = colours;
    mesh.normals = normals;
    mesh.texcoords = texcoords;
    mesh.triangles = triangles;
    texture = {texels, 4, 3};
    Scene s;
    s.meshes = {&mesh, 1};
    s.materials = {&material, 1};
    s.instances = {&instance, 1};
    s.lights = {&light, 1};
    if (!texels.empty()) s.textures = {&texture, 1};
    s.background = {16, 32, 48, 255};
    return s;
  }
};

inline Model random_model(unsigned seed, int triangles, int extent) {
  std::mt19937 random(seed);
  const auto between = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  Model model;
  for (int t = 0; t < triangles; ++t) {
    const int c[3] = {between(-30000, 30000), between(-30000, 30000), between(-30000, 30000)};
    for (int k = 0; k < 3; ++k) {
      const auto near = [&](int axis) {
        return static_cast<std::int16_t>(std::clamp(c[axis] + between(-extent, extent), -32767, 32767));
      };
      model.positions.push_back({near(0), near(1), near(2)});
      const auto byte = [&] { return static_cast<std::uint8_t>(between(0, 255)); };
      model.colours.push_back({byte(), byte(), byte(), 255});
      model.normals.push_back(
          {static_cast<std::int8_t>(between(-73, 73)), static_cast<std::int8_t>(between(-73, 73)), 73, 0});
      model.texcoords.push_back(
          {static_cast<std::int16_t>(between(-9000, 9000)), static_cast<std::int16_t>(between(-9000, 9000))});
    }
    const auto v = static_cast<std::uint16_t>(3 * t);
    model.triangles.push_back({v, static_cast<std::uint16_t>(v + 1), static_cast<std::uint16_t>(v + 2)});
  }
  for (int i = 0; i < 128; ++i) model.texels.push_back(static_cast<std::uint16_t>(between(0, 65535)));
  model.material.double_sided = true;
  return model;
}

/// With all that the scene calls for, and its statistics.
inline Picture render(const Scene& scene, const Camera& camera, const View& view, std::uint16_t strip_rows,
                      std::uint8_t garbage = 0xA5) {
  return draw(effects_of(scene, camera) | effect::statistics, scene, camera, view, {.strip_rows = strip_rows},
              {.garbage = garbage});
}

/// A square in the plane z = 0 of the given half size (16.16), cut into n x n cells of two triangles.
inline Model grid(int n, Fixed half) {
  Model model;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      const auto at = [n](int i) { return static_cast<std::int16_t>(-32767 + 65534 * i / n); };
      model.positions.push_back({at(x), at(y), 0});
    }
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const auto v = [n](int i, int j) { return static_cast<std::uint16_t>(j * (n + 1) + i); };
      model.triangles.push_back({v(x, y), v(x + 1, y), v(x + 1, y + 1)});
      model.triangles.push_back({v(x, y), v(x + 1, y + 1), v(x, y + 1)});
    }
  }
  model.mesh.half_extent = {half, half, half};
  model.material.lit = false;
  return model;
}

}  // namespace picture
