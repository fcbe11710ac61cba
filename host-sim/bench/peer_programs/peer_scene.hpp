// A workload for other renderers, in floating point.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "zstrip_scenes/scenes.hpp"

namespace zstrip::peer {

struct Vertex {
  float x, y, z;            ///< in the model's space
  float u, v;               ///< 1 is the whole texture; v grows downwards
  std::uint8_t r, g, b, a;  ///< as zstrip draws it without light
};

/// The matrices of one frame, column-major as in OpenGL.
struct View {
  std::array<float, 16> modelview;
  std::array<float, 16> projection;
};

/// One unlit instance of one mesh, as the benchmark's scenes have.
class Scene {
 public:
  /// `scene` is the name of a built-in scene; returns nothing if there is no such scene, or if it is of another kind.
  static std::optional<Scene> open(const std::string& scene);

  std::span<const Vertex> vertices() const { return vertices_; }
  std::span<const Triangle> triangles() const { return mesh_->triangles; }
  bool smooth() const { return material_->smooth; }
  bool double_sided() const { return material_->double_sided; }
  /// Returns the texture, or null if there is none.
  const Texture* texture() const { return texture_; }
  Colour background() const { return built_in_->scene.background; }
  /// Returns camera and model matrices of a frame of the workload.
  View view(std::uint32_t frame, int width, int height) const;

 private:
  const scenes::BuiltIn* built_in_ = nullptr;
  const Mesh* mesh_ = nullptr;
  const Material* material_ = nullptr;
  const Texture* texture_ = nullptr;
  std::vector<Vertex> vertices_;
};

}  // namespace zstrip::peer
