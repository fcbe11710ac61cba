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
/// origin. A rotation by 90 degrees about z does not change it, so that its picture from +z is as wide as it is high.
/// Made with integers only, equal on every host.
class TorusKnot {
 public:
  TorusKnot();
  TorusKnot(const TorusKnot&) = delete;
  TorusKnot& operator=(const TorusKnot&) = delete;

  /// Returns one mesh for each 65,535 vertices, which is one here; valid as long as this object.
  const std::vector<Mesh>& meshes() const { return meshes_; }

 private:
  std::vector<MeshData> data_;
  std::vector<Mesh> meshes_;
};

}  // namespace zstrip::sim
