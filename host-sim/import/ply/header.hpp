// The header of a PLY file: its elements and their properties.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "result.hpp"

namespace zstrip::sim {

enum class PlyFormat : std::uint8_t { text, little_endian, big_endian };

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytes_of(PlyType type);

struct PlyProperty {
  std::string name;  ///< in small letters
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
  std::string name;  ///< in small letters
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Returns the index of the first property with one of these names; properties.size() if there is none.
  std::size_t find(std::initializer_list<std::string_view> names) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
  std::string texture;    ///< the picture that a comment names; may be empty
  std::size_t bytes = 0;  ///< length of the header with its last line end
};

/// Lines end in CR, LF or both. The failure's message is a reason.
Result<PlyHeader> read_ply_header(std::string_view file);

}  // namespace zstrip::sim
