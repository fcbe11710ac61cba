// Worlds of one mesh with its edges, cameras for them, and how far a picture with them is from a true one.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "../oracle/vectors.hpp"
#include "edges_of.hpp"
#include "own_mesh.hpp"
#include "samples.hpp"

namespace effects_test {

using oracle::to_fixed;
using zstrip::test::OwnMesh;

inline constexpr double kPi = 3.14159265358979;
inline constexpr View kSquare{64, 64};
/// As many units fill the picture's height as its pixels are.
inline constexpr double kPixel = 1.0 / 16;

inline Transform turned_flat(double angle, double scale, double x, double y, double z) {
  const Fixed c = to_fixed(scale * std::cos(angle)), s = to_fixed(scale * std::sin(angle));
  return {{{c, -s, 0, to_fixed(x)}, {s, c, 0, to_fixed(y)}, {0, 0, to_fixed(scale), to_fixed(z)}}};
}

/// Looks along -z at the origin: 4 units fill the height.
inline Camera parallel_camera() {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.eye = {0, 0, to_fixed(10)};
  camera.focal = to_fixed(0.5);
  camera.near_plane = to_fixed(1);
  camera.far_plane = to_fixed(20);
  return camera;
}

/// A square of half a side 1 that faces +z, in two triangles.
inline OwnMesh square() {
  OwnMesh own;
  for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    own.positions.push_back({static_cast<std::int16_t>(32767 * x), static_cast<std::int16_t>(32767 * y), 0});
    own.normals.push_back({0, 0, 127, 0});
  }
  own.triangles = {{0, 1, 2}, {0, 2, 3}};
  return own;
}

/// Instances of one mesh, without light, each with a material of its own.
struct World {
  OwnMesh own;
  Mesh meshes[1];
  std::vector<Edge> edges;
  EdgeSet sets[1];
  std::vector<Material> materials;
  std::vector<Instance> instances;
  Scene scene;

  World(const OwnMesh& shape, bool creases) : own(shape) {
    meshes[0] = own.mesh();
    edges = edges_of_mesh(meshes[0], [this, creases](std::size_t i, std::size_t j) {
      const Normal& a = own.normals[own.triangles[i].a];
      const Normal& b = own.normals[own.triangles[j].a];
      return creases && (a.x != b.x || a.y != b.y || a.z != b.z);
    });
    sets[0] = {edges, 0};
    scene.meshes = meshes;
    scene.edges = sets;
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void add(const Colour& colour, const Transform& transform, bool lit = false) {
    instances.push_back({.mesh = 0, .material = static_cast<std::uint16_t>(materials.size()), .transform = transform});
    materials.push_back({.colour = colour, .lit = lit, .smooth = false});
    scene.materials = materials;
    scene.instances = instances;
  }
  Scene without_edges() const {
    Scene plain = scene;
    plain.edges = {};
    return plain;
  }
};

inline constexpr Effects kFlatEdges = effect::orthographic | effect::edges | effect::bins;

/// Mean difference of all channels from the means of a picture of `factor` times as many rows and columns, 0..1.
inline double distance_from(const Drawn& large, const Drawn& drawn, int factor) {
  double sum = 0;
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      for (const auto& [shift, most] : {std::array{11, 31}, {5, 63}, {0, 31}}) {
        double mean = 0;
        for (int i = 0; i < factor * factor; ++i) {
          mean += large.at(x * factor + i % factor, y * factor + i / factor) >> shift & most;
        }
        sum += std::abs(mean / (factor * factor) - (drawn.at(x, y) >> shift & most)) / most;
      }
    }
  }
  return sum / (drawn.width * drawn.height * 3);
}

/// How far from a picture of four times as many rows and columns it is, with edges over without.
template <Effects effects>
inline double share_of_error(const Scene& scene, const Camera& camera, const View& view) {
  constexpr int kFactor = 4;
  Scene plain = scene;
  plain.edges = {};
  const View larger{static_cast<std::uint16_t>(view.width * kFactor),
                    static_cast<std::uint16_t>(view.height * kFactor)};
  const Drawn large = draw<effects>(plain, camera, larger);
  const double with = distance_from(large, draw<effects>(scene, camera, view), kFactor);
  return with / distance_from(large, draw<effects>(plain, camera, view), kFactor);
}

inline Camera near_camera(double distance) {
  Camera camera;
  camera.eye = {0, 0, to_fixed(distance)};
  camera.focal = to_fixed(1.5);
  camera.near_plane = to_fixed(0.1);
  camera.far_plane = to_fixed(50);
  return camera;
}

inline Transform turned_about_x_and_y(double x, double y, double scale = 1) {
  const double cx = std::cos(x), sx = std::sin(x), cy = std::cos(y), sy = std::sin(y);
  const auto f = [scale](double value) { return to_fixed(scale * value); };
  return {{{f(cy), f(sy * sx), f(sy * cx), 0}, {0, f(cx), f(-sx), 0}, {f(-sy), f(cy * sx), f(cy * cx), 0}}};
}

}  // namespace effects_test
