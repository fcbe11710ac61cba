// The numbers of a primitive: from accessors, or from the compressed mesh that replaces them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "import/gltf/accessors.hpp"
#include "import/gltf/buffers.hpp"
#include "import/gltf/draco_meshes.hpp"
#include "import/gltf/json.hpp"
#include "result.hpp"

namespace zstrip::sim {

class GltfAttributes {
 public:
  /// `primitive` must outlive the result. The failure's message is a reason, as for all functions below.
  static Result<GltfAttributes> open(const GltfJson& primitive, GltfAccessors& accessors, GltfBuffers& buffers);

  /// True if the primitive has this attribute ("POSITION").
  bool has(const std::string& name) const;
  /// Returns at least `vertices` elements with at least `least` components; empty if the attribute does not exist.
  Result<GltfValues<float>> floats(const std::string& name, std::size_t vertices, std::size_t least) const;
  Result<GltfValues<std::uint32_t>> integers(const std::string& name, std::size_t vertices, std::size_t least) const;
  /// Returns the indices; if there are none, those of all vertices in order.
  Result<std::vector<std::uint32_t>> indices(std::size_t vertices) const;

 private:
  GltfAttributes(const GltfJson& primitive, GltfAccessors& accessors)
      : primitive_(&primitive), accessors_(&accessors) {}
  const GltfValues<float>* decoded(const std::string& name) const;

  const GltfJson* primitive_;
  GltfAccessors* accessors_;
  std::optional<DracoMesh> compressed_;
};

/// Reads one accessor; fails if it has fewer elements or components, or more than four components. `what`: for
/// messages.
Result<GltfValues<float>> fitting_floats(GltfAccessors& accessors, std::size_t accessor, const std::string& what,
                                         std::size_t vertices, std::size_t least);

}  // namespace zstrip::sim
