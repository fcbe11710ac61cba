// The scene of the dynamic z-buffer's table: a torus knot of 60,000 triangles, in meshlets.
#pragma once

#include <cstddef>
#include <vector>

#include "import/model.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

inline constexpr std::size_t kTorusKnotRings = 600;
inline constexpr std::size_t kTorusKnotRingVertices = 50;
inline constexpr std::size_t kTorusKnotTriangles = 2 * kTorusKnotRings * kTorusKnotRingVertices;
static_assert(kTorusKnotTriangles == 60'000);

/// A closed tube, with a colour at each vertex. World units: it reaches +-1.62 in x and y and +-0.62 in z, around the
/// origin. Turned by a quarter about z it is the same again, so that its picture from +z is as wide as it is high. Made
/// with integers only, the same on every host.
class TorusKnot {
 public:
  TorusKnot();
  TorusKnot(const TorusKnot&) = delete;
  TorusKnot& operator=(const TorusKnot&) = delete;

  /// One for each 65,535 vertices, which is one here; as long as this object lives.
  const std::vector<Mesh>& meshes() const { return meshes_; }

 private:
  std::vector<MeshData> data_;
  std::vector<Mesh> meshes_;
};

}  // namespace zstrip::sim
