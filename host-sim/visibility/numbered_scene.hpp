// A scene whose triangles have different colours, so that a picture shows the visible triangle of each pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "result.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Owns the data of its scene: the same triangles in the same order, meshlets and instances, without light and
/// textures. Meshes are cut if their vertices, three a triangle, would be more than a mesh can have.
class NumberedScene {
 public:
  static constexpr std::size_t kMaxTriangles = 65535;

  /// Returns a usage error if there are more triangles than colours.
  static Result<NumberedScene> of(const Scene& scene);

  Scene scene() const;
  /// Returns the RGB565 pixel of triangle n, counted over all instances; 0 is the background.
  static std::uint16_t pixel(std::size_t triangle) { return static_cast<std::uint16_t>(triangle + 1); }

 private:
  struct MeshData {
    std::vector<Position> positions;
    std::vector<Colour> colours;
    std::vector<Triangle> triangles;
    std::vector<Meshlet> meshlets;
  };
  void add(const Mesh& mesh, const Instance& instance, std::size_t first, std::size_t count,
           std::span<const Meshlet> meshlets);

  std::vector<MeshData> data_;
  std::vector<Mesh> meshes_;
  std::vector<Material> materials_;
  std::vector<Instance> instances_;
  std::size_t triangles_ = 0;
};

}  // namespace zstrip::sim
