// The numbers of a glTF file.
#include "import/gltf/accessors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

namespace zstrip::sim {
namespace {

/// Larger than any model's number of vertices: a small file must not request gigabytes.
constexpr std::size_t kMaxElements = 30'000'000;
/// Zeros of an accessor without a buffer view, which take no bytes of the file.
constexpr std::size_t kMaxZeros = 4'000'000;

enum class Component : std::size_t {
  byte = 5120,
  unsigned_byte = 5121,
  short_integer = 5122,
  unsigned_short = 5123,
  unsigned_integer = 5125,
  floating = 5126,
};

std::size_t bytes_of(Component component) {
  switch (component) {
    case Component::byte:
    case Component::unsigned_byte: return 1;
    case Component::short_integer:
    case Component::unsigned_short: return 2;
    case Component::unsigned_integer:
    case Component::floating: break;
  }
  return 4;
}

std::optional<Component> component_in(const GltfJson& json) {
  const std::size_t number = index_in(json, "componentType").value_or(0);
  if (number < 5120 || number > 5126 || number == 5124) return std::nullopt;
  return static_cast<Component>(number);
}

/// The layout of an element: columns of `rows` numbers each, each column at a multiple of four bytes.
struct Shape {
  std::size_t columns = 1, rows = 1;
};

std::optional<Shape> shape_in(const GltfJson& json) {
  const std::string type = text_in(json, "type");
  if (type == "SCALAR") return Shape{1, 1};
  if (type == "VEC2") return Shape{1, 2};
  if (type == "VEC3") return Shape{1, 3};
  if (type == "VEC4") return Shape{1, 4};
  if (type == "MAT2") return Shape{2, 2};
  if (type == "MAT3") return Shape{3, 3};
  if (type == "MAT4") return Shape{4, 4};
  return std::nullopt;
}

/// Reads little-endian values at any address.
template <typename Stored>
Stored stored_at(const std::uint8_t* bytes) {
  static_assert(std::endian::native == std::endian::little);
  Stored value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

double number_at(const std::uint8_t* bytes, Component component, bool normalised) {
  const auto scaled = [normalised](double value, double largest) {
    return normalised ? std::max(value / largest, -1.0) : value;
  };
  switch (component) {
    case Component::byte: return scaled(stored_at<std::int8_t>(bytes), 127);
    case Component::unsigned_byte: return scaled(stored_at<std::uint8_t>(bytes), 255);
    case Component::short_integer: return scaled(stored_at<std::int16_t>(bytes), 32767);
    case Component::unsigned_short: return scaled(stored_at<std::uint16_t>(bytes), 65535);
    case Component::unsigned_integer: return scaled(stored_at<std::uint32_t>(bytes), 4294967295.0);
    case Component::floating: break;
  }
  return double{stored_at<float>(bytes)};
}

/// The location of elements, which is known to be inside their view.
struct Layout {
  std::span<const std::uint8_t> bytes;
  std::size_t stride = 0;
  Component component = Component::floating;
  Shape shape;
  bool normalised = false;

  std::size_t column_bytes() const {
    const std::size_t size = shape.rows * bytes_of(component);
    return shape.columns == 1 ? size : (size + 3) / 4 * 4;
  }
  /// Returns the bytes of an element without padding after the last number.
  std::size_t element_bytes() const { return (shape.columns - 1) * column_bytes() + shape.rows * bytes_of(component); }
  template <typename Number>
  Number number(std::size_t element, std::size_t column, std::size_t row) const {
    const std::uint8_t* at = bytes.data() + element * stride + column * column_bytes() + row * bytes_of(component);
    if constexpr (std::is_same_v<Number, std::uint32_t>) {
      if (component == Component::unsigned_byte) return stored_at<std::uint8_t>(at);
      if (component == Component::unsigned_short) return stored_at<std::uint16_t>(at);
      return stored_at<std::uint32_t>(at);
    } else {
      return static_cast<Number>(number_at(at, component, normalised));
    }
  }
};

bool is_unsigned(Component component) {
  return component == Component::unsigned_byte || component == Component::unsigned_short ||
         component == Component::unsigned_integer;
}

/// Sets the location to the view's bytes from `part`'s offset on, if `count` elements fit.
Result<Done> place(GltfBuffers& buffers, const GltfJson& part, std::size_t count, const std::string& name,
                   Layout& layout) {
  const std::optional<std::size_t> index = index_in(part, "bufferView");
  if (!index) return gltf_damaged(fmt::format("{} has no buffer view", name));
  const Result<GltfBuffers::View> view = buffers.view(*index);
  if (!view) return view.failure();
  const std::size_t offset = index_in(part, "byteOffset").value_or(0);
  const std::size_t element = layout.element_bytes();
  layout.stride = view->stride != 0 ? view->stride : layout.shape.columns * layout.column_bytes();
  const std::size_t size = view->bytes.size();
  if (offset > size || element > size - offset || (count - 1) > (size - offset - element) / layout.stride) {
    return gltf_damaged(fmt::format("{} reaches beyond its buffer view", name));
  }
  layout.bytes = view->bytes.subspan(offset);
  return Done{};
}

template <typename Number>
void read_element(const Layout& layout, std::size_t element, Number* to) {
  for (std::size_t column = 0; column < layout.shape.columns; ++column) {
    for (std::size_t row = 0; row < layout.shape.rows; ++row) *to++ = layout.number<Number>(element, column, row);
  }
}

/// Replaces the elements that a sparse accessor lists.
template <typename Number>
Result<Done> replace_elements(GltfBuffers& buffers, const GltfJson& sparse, Layout layout, const std::string& name,
                              GltfValues<Number>& values) {
  const std::size_t count = index_in(sparse, "count").value_or(0);
  const std::optional<Component> component = component_in(member(sparse, "indices"));
  if (count == 0 || count > values.count() || !component || !is_unsigned(*component)) {
    return gltf_damaged(fmt::format("{} is sparse in a way that does not fit it", name));
  }
  Layout indices{.bytes = {}, .component = *component, .shape = {}};
  if (const Result<Done> done = place(buffers, member(sparse, "indices"), count, name, indices); !done)
    return done.failure();
  if (const Result<Done> done = place(buffers, member(sparse, "values"), count, name, layout); !done)
    return done.failure();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index = indices.number<std::uint32_t>(i, 0, 0);
    if (index >= values.count()) return gltf_damaged(fmt::format("{} lists an element that it does not have", name));
    read_element(layout, i, values.numbers.data() + index * values.components);
  }
  return Done{};
}

}  // namespace

template <typename Number>
Result<GltfValues<Number>> GltfAccessors::read(std::size_t accessor) {
  const std::string name = fmt::format("accessor {}", accessor);
  const GltfJson& from = element(member(document_.json, "accessors"), accessor);
  const std::size_t count = index_in(from, "count").value_or(0);
  const std::optional<Component> component = component_in(from);
  const std::optional<Shape> shape = shape_in(from);
  if (!component || !shape || count == 0) return gltf_damaged(fmt::format("{} is missing or damaged", name));
  if (count > kMaxElements) return gltf_damaged(fmt::format("{} has too many elements", name));
  if (std::is_same_v<Number, std::uint32_t> && !is_unsigned(*component)) {
    return gltf_damaged(fmt::format("{} has no unsigned integers", name));
  }
  Layout layout{.bytes = {},
                .component = *component,
                .shape = *shape,
                .normalised = flag_in(from, "normalized") && *component != Component::floating};
  const GltfJson& sparse = member(from, "sparse");
  GltfValues<Number> values{.components = shape->columns * shape->rows, .numbers = {}};
  // Without a view all elements are zero.
  if (member(from, "bufferView").is_null()) {
    if (count > kMaxZeros / values.components) {
      return gltf_damaged(fmt::format("{} has too many elements without a buffer view", name));
    }
    values.numbers.resize(count * values.components);
  } else {
    if (const Result<Done> placed = place(buffers_, from, count, name, layout); !placed) return placed.failure();
    values.numbers.resize(count * values.components);
    for (std::size_t i = 0; i < count; ++i) read_element(layout, i, values.numbers.data() + i * values.components);
  }
  if (sparse.is_object()) {
    if (const Result<Done> done = replace_elements(buffers_, sparse, layout, name, values); !done) {
      return done.failure();
    }
  }
  return values;
}

Result<GltfValues<float>> GltfAccessors::floats(std::size_t accessor) { return read<float>(accessor); }
Result<GltfValues<std::uint32_t>> GltfAccessors::integers(std::size_t accessor) {
  return read<std::uint32_t>(accessor);
}

}  // namespace zstrip::sim
