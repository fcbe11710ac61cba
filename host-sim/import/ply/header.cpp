// The header of a PLY file: its elements and their properties.
#include "import/ply/header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::string_view kBlanks = " \t";

Failure wrong(std::string reason) { return {ExitStatus::input, std::move(reason)}; }

/// Removes the next word from `line` and returns it; empty if there is none.
std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
  line.remove_prefix(word.size());
  return word;
}

std::optional<PlyType> type_of(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> kNames{{{"char", PlyType::int8},
                                                                         {"int8", PlyType::int8},
                                                                         {"uchar", PlyType::uint8},
                                                                         {"uint8", PlyType::uint8},
                                                                         {"short", PlyType::int16},
                                                                         {"int16", PlyType::int16},
                                                                         {"ushort", PlyType::uint16},
                                                                         {"uint16", PlyType::uint16},
                                                                         {"int", PlyType::int32},
                                                                         {"int32", PlyType::int32},
                                                                         {"uint", PlyType::uint32},
                                                                         {"uint32", PlyType::uint32},
                                                                         {"float", PlyType::float32},
                                                                         {"float32", PlyType::float32},
                                                                         {"double", PlyType::float64},
                                                                         {"float64", PlyType::float64}}};
  const std::string name = lower(std::string(word));
  for (const auto& [known, type] : kNames) {
    if (name == known) return type;
  }
  return std::nullopt;
}

std::optional<PlyProperty> property_of(std::string_view rest) {
  PlyProperty property;
  std::string_view type = take_word(rest);
  if (lower(std::string(type)) == "list") {
    property.is_list = true;
    const std::optional<PlyType> count = type_of(take_word(rest));
    if (!count) return std::nullopt;
    property.count_type = *count;
    type = take_word(rest);
  }
  const std::optional<PlyType> known = type_of(type);
  property.name = lower(std::string(take_word(rest)));
  if (!known || property.name.empty()) return std::nullopt;
  property.type = *known;
  return property;
}

std::optional<PlyElement> element_of(std::string_view rest) {
  PlyElement element;
  element.name = lower(std::string(take_word(rest)));
  const std::string_view count = take_word(rest);
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (error != std::errc() || end != count.data() + count.size()) return std::nullopt;
  return element;
}

std::optional<PlyFormat> format_of(std::string_view rest) {
  const std::string word = lower(std::string(take_word(rest)));
  if (word == "ascii") return PlyFormat::text;
  if (word == "binary_little_endian") return PlyFormat::little_endian;
  if (word == "binary_big_endian") return PlyFormat::big_endian;
  return std::nullopt;
}

/// "TextureFile name", with blanks in the name.
std::string texture_of(std::string_view comment) {
  if (lower(std::string(take_word(comment))) != "texturefile") return {};
  comment.remove_prefix(std::min(comment.find_first_not_of(kBlanks), comment.size()));
  const std::size_t last = comment.find_last_not_of(kBlanks);
  return last == std::string_view::npos ? std::string() : std::string(comment.substr(0, last + 1));
}

}  // namespace

std::size_t bytes_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kBytes{1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[static_cast<std::size_t>(type)];
}

std::size_t PlyElement::find(std::initializer_list<std::string_view> names) const {
  const auto at = std::ranges::find_if(
      properties, [&](const PlyProperty& property) { return std::ranges::find(names, property.name) != names.end(); });
  return static_cast<std::size_t>(at - properties.begin());
}

Result<PlyHeader> read_ply_header(std::string_view file) {
  PlyHeader header;
  bool has_format = false, begins = false;
  std::size_t at = 0;
  while (at < file.size()) {
    const std::size_t end = file.find_first_of("\r\n", at);
    if (end == std::string_view::npos) break;
    std::string_view rest = file.substr(at, end - at);
    at = end + (file.substr(end).starts_with("\r\n") ? 2 : 1);
    const std::string key = lower(std::string(take_word(rest)));
    if (!begins && !key.empty() && key != "ply") return wrong("its first line is not 'ply'");
    if (key == "ply") begins = true;
    if (key == "end_header") {
      if (!has_format) return wrong("its header has no format");
      header.bytes = at;
      return header;
    }
    if (key == "format") {
      const std::optional<PlyFormat> format = format_of(rest);
      if (!format) return wrong("its header has a format that PLY does not have");
      header.format = *format;
      has_format = true;
    } else if (key == "comment") {
      if (header.texture.empty()) header.texture = texture_of(rest);
    } else if (key == "element") {
      std::optional<PlyElement> element = element_of(rest);
      if (!element) return wrong("its header has an element without a count");
      header.elements.push_back(std::move(*element));
    } else if (key == "property") {
      std::optional<PlyProperty> property = property_of(rest);
      if (!property) return wrong("its header has a property of an unknown type");
      if (header.elements.empty()) return wrong("its header has a property before the first element");
      header.elements.back().properties.push_back(std::move(*property));
    }
  }
  return wrong("the file ends in its header");
}

}  // namespace zstrip::sim
