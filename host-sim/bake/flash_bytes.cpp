// What a scene takes of the flash, by kind.
#include "bake/flash_bytes.hpp"

namespace zstrip::sim {
namespace {

// With addresses of 32 bits; core/zstrip/scene/scene_blob.cpp asserts them on such targets.
constexpr std::uint64_t kSceneBytes = 68, kCameraBytes = 64;

}  // namespace

std::uint64_t table_bytes(const Scene& scene) {
  constexpr std::uint64_t kMeshBytes = 76, kTextureBytes = 12;
  return scene.meshes.size() * kMeshBytes + scene.textures.size() * kTextureBytes;
}

FlashBytes flash_bytes(const Scene& scene) {
  FlashBytes bytes;
  for (const Mesh& mesh : scene.meshes) {
    bytes.positions += mesh.positions.size_bytes();
    bytes.normals += mesh.normals.size_bytes();
    bytes.colours += mesh.colours.size_bytes();
    bytes.texcoords += mesh.texcoords.size_bytes();
    bytes.triangles += mesh.triangles.size_bytes();
    bytes.meshlets += mesh.meshlets.size_bytes();
  }
  for (const Texture& texture : scene.textures) bytes.texels += texture.texels.size_bytes();
  bytes.tables = table_bytes(scene) + scene.materials.size_bytes() + scene.instances.size_bytes() +
                 scene.lights.size_bytes() + scene.finishes.size_bytes() + scene.punctual_lights.size_bytes() +
                 (scene.fog != nullptr ? sizeof(Fog) : 0) + kSceneBytes + kCameraBytes;
  return bytes;
}

}  // namespace zstrip::sim
