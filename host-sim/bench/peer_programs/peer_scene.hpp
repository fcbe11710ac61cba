// A workload as other renderers take it: in floating point.
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

/// Of one frame, column-major as OpenGL keeps matrices.
struct View {
  std::array<float, 16> modelview;
  std::array<float, 16> projection;
};

/// One unlit instance of one mesh, as the benchmark's scenes have.
class Scene {
 public:
  /// `scene` is the name of a built-in one; empty if there is none, or if it is of another kind.
  static std::optional<Scene> open(const std::string& scene);

  std::span<const Vertex> vertices() const { return vertices_; }
  std::span<const Triangle> triangles() const { return mesh_->triangles; }
  bool smooth() const { return material_->smooth; }
  bool double_sided() const { return material_->double_sided; }
  /// Null without one.
  const Texture* texture() const { return texture_; }
  Colour background() const { return built_in_->scene.background; }
  /// Camera and model of a frame of the workload.
  View view(std::uint32_t frame, int width, int height) const;

 private:
  const scenes::BuiltIn* built_in_ = nullptr;
  const Mesh* mesh_ = nullptr;
  const Material* material_ = nullptr;
  const Texture* texture_ = nullptr;
  std::vector<Vertex> vertices_;
};

}  // namespace zstrip::peer
