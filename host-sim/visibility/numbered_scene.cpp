// Gives each triangle its own vertices and colour.
#include "visibility/numbered_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace zstrip::sim {
namespace {

constexpr std::size_t kMaxTrianglesOfMesh = 65535 / 3;

/// Returns the colour that becomes `pixel` in RGB565.
Colour colour_of(std::uint16_t pixel) {
  return {static_cast<std::uint8_t>((pixel >> 11) << 3), static_cast<std::uint8_t>(((pixel >> 5) & 63) << 2),
          static_cast<std::uint8_t>((pixel & 31) << 3), 255};
}

}  // namespace

Result<NumberedScene> NumberedScene::of(const Scene& scene) {
  NumberedScene numbered;
  for (const Material& material : scene.materials) {
    Material plain = material;
    plain.colour = {255, 255, 255, 255};
    plain.texture = kNoTexture;
    plain.lit = false;
    plain.smooth = false;
    numbered.materials_.push_back(plain);
  }
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    if (numbered.triangles_ + mesh.triangles.size() > kMaxTriangles) {
      return Failure{ExitStatus::usage,
                     fmt::format("a scene of more than {} triangles cannot be judged", kMaxTriangles)};
    }
    if (mesh.meshlets.empty()) {
      for (std::size_t first = 0; first < mesh.triangles.size(); first += kMaxTrianglesOfMesh) {
        numbered.add(mesh, instance, first, std::min(kMaxTrianglesOfMesh, mesh.triangles.size() - first), {});
      }
    }
    for (std::size_t first = 0, end; first < mesh.meshlets.size(); first = end) {
      std::size_t triangles = 0;
      for (end = first; end < mesh.meshlets.size(); ++end) {
        if (triangles + mesh.meshlets[end].triangle_count > kMaxTrianglesOfMesh) break;
        triangles += mesh.meshlets[end].triangle_count;
      }
      if (end == first) return Failure{ExitStatus::usage, "a scene with meshlets of that size cannot be judged"};
      numbered.add(mesh, instance, mesh.meshlets[first].first_triangle, triangles,
                   mesh.meshlets.subspan(first, end - first));
    }
  }
  return numbered;
}

void NumberedScene::add(const Mesh& mesh, const Instance& instance, std::size_t first, std::size_t count,
                        std::span<const Meshlet> meshlets) {
  MeshData data;
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle& triangle = mesh.triangles[first + i];
    const auto vertex = static_cast<std::uint16_t>(3 * i);
    data.triangles.push_back({vertex, static_cast<std::uint16_t>(vertex + 1), static_cast<std::uint16_t>(vertex + 2)});
    for (const std::uint16_t index : {triangle.a, triangle.b, triangle.c}) {
      data.positions.push_back(mesh.positions[index]);
      data.colours.push_back(colour_of(pixel(triangles_ + i)));
    }
  }
  triangles_ += count;
  for (Meshlet meshlet : meshlets) {
    meshlet.first_triangle -= static_cast<std::uint32_t>(first);
    meshlet.first_vertex = static_cast<std::uint16_t>(3 * meshlet.first_triangle);
    meshlet.vertex_count = static_cast<std::uint16_t>(3 * meshlet.triangle_count);
    data.meshlets.push_back(meshlet);
  }
  Instance own = instance;
  own.mesh = static_cast<std::uint16_t>(meshes_.size());
  instances_.push_back(own);
  data_.push_back(std::move(data));
  const MeshData& kept = data_.back();  // a vector's memory stays where it is when the vector itself moves
  meshes_.push_back({.positions = kept.positions,
                     .normals = {},
                     .colours = kept.colours,
                     .texcoords = {},
                     .triangles = kept.triangles,
                     .meshlets = kept.meshlets,
                     .centre = mesh.centre,
                     .half_extent = mesh.half_extent,
                     .billboard = mesh.billboard});
}

Scene NumberedScene::scene() const {
  return {.meshes = meshes_,
          .materials = materials_,
          .textures = {},
          .instances = instances_,
          .lights = {},
          .ambient = {},
          .background = {0, 0, 0, 255}};
}

}  // namespace zstrip::sim
