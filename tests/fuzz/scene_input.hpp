// A scene with camera, view and budget, read from the fuzzer's bytes.
#pragma once

#include <vector>

#include "input.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace fuzz {

/// Owns everything that the scene refers to, each array in heap memory of exactly its size. The first byte says which
/// parts keep to the documented ranges; the others hold whatever the bytes say.
class SceneInput {
 public:
  explicit SceneInput(Input& input);
  SceneInput(const SceneInput&) = delete;
  SceneInput& operator=(const SceneInput&) = delete;

  const zstrip::Scene& scene() const { return scene_; }
  const zstrip::Camera& camera() const { return camera_; }
  const zstrip::View& view() const { return view_; }
  const zstrip::Budget& budget() const { return budget_; }

 private:
  /// The parts that may be anything: bits of the first byte.
  struct Hostile {
    bool meshes, materials, textures, instances, lights, camera, view;
  };
  struct MeshArrays {
    std::vector<zstrip::Position> positions;
    std::vector<zstrip::Normal> normals;
    std::vector<zstrip::Colour> colours;
    std::vector<zstrip::TexCoord> texcoords;
    std::vector<zstrip::Triangle> triangles;
    std::vector<zstrip::Meshlet> meshlets;
  };

  static Hostile read_hostile(Input& input);
  void read_products(Input& input);
  void read_view(Input& input);
  void read_camera(Input& input);
  void read_texture(Input& input, std::size_t index);
  void read_material(Input& input, zstrip::Material& material) const;
  void read_mesh(Input& input, MeshArrays& arrays, zstrip::Mesh& mesh) const;
  void read_triangles(Input& input, MeshArrays& arrays) const;
  void read_meshlets(Input& input, MeshArrays& arrays) const;
  void read_instance(Input& input, zstrip::Instance& instance) const;

  Hostile hostile_;
  std::vector<std::vector<std::uint16_t>> texels_;
  std::vector<zstrip::Texture> textures_;
  std::vector<zstrip::Material> materials_;
  std::vector<MeshArrays> arrays_;
  std::vector<zstrip::Mesh> meshes_;
  std::vector<zstrip::Outline> outlines_;
  std::vector<zstrip::Instance> instances_;
  std::vector<zstrip::DirectionalLight> lights_;
  zstrip::Shadow shadow_;
  std::vector<zstrip::CsgOperand> operands_;
  zstrip::Scene scene_;
  zstrip::Camera camera_;
  zstrip::View view_;
  zstrip::Budget budget_;
};

}  // namespace fuzz
