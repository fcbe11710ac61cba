// The numbers of a glTF file: accessors of any type, normalised, interleaved, sparse; all checked before they are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "import/gltf/buffers.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The numbers of an accessor, element after element, each with its components; matrices column by column.
template <typename Number>
struct GltfValues {
  std::size_t components = 0;
  std::vector<Number> numbers;

  std::size_t count() const { return components == 0 ? 0 : numbers.size() / components; }
  const Number* at(std::size_t index) const { return numbers.data() + index * components; }
};

class GltfAccessors {
 public:
  GltfAccessors(const GltfDocument& document, GltfBuffers& buffers) : document_(document), buffers_(buffers) {}

  /// Normalised integers become 0..1 or -1..1, others are not scaled. The failure's message is a reason.
  Result<GltfValues<float>> floats(std::size_t accessor);
  /// Returns unsigned integers, not scaled.
  Result<GltfValues<std::uint32_t>> integers(std::size_t accessor);

 private:
  template <typename Number>
  Result<GltfValues<Number>> read(std::size_t accessor);

  const GltfDocument& document_;
  GltfBuffers& buffers_;
};

}  // namespace zstrip::sim
