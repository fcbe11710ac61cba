// Converts STL to a form that Assimp 5.2 reads correctly.
#include "import/assimp/stl_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace zstrip::sim {
namespace {

constexpr std::size_t kHeaderBytes = 84, kTriangleBytes = 50;  // the header ends with the number of triangles
constexpr std::string_view kBlanks = " \t\r\n";

std::size_t triangles_of(std::string_view bytes) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) count |= std::size_t{static_cast<std::uint8_t>(bytes[80 + i])} << 8 * i;
  return count;
}

/// Gives each triangle its own colour, and bit 15 the same meaning as in other files.
void set_colours_of_magics(std::string& bytes) {
  constexpr std::string_view kColour = "COLOR=";  // red, green, blue, alpha
  const std::size_t name = std::string_view(bytes).substr(0, kHeaderBytes - 4).find(kColour);
  if (name > kHeaderBytes - 4 - kColour.size() - 4) return;
  const auto five_bits = [&](std::size_t channel) {
    return static_cast<std::uint8_t>(bytes[name + kColour.size() + channel]) >> 3;
  };
  const int whole = five_bits(0) | five_bits(1) << 5 | five_bits(2) << 10;
  for (std::size_t at = kHeaderBytes + kTriangleBytes - 2; at < bytes.size(); at += kTriangleBytes) {
    const int own = static_cast<std::uint8_t>(bytes[at]) | static_cast<std::uint8_t>(bytes[at + 1]) << 8;
    const int colour = own == 0 || (own & 0x8000) != 0 ? whole : own;
    bytes[at] = static_cast<char>(colour & 0xFF);
    bytes[at + 1] = static_cast<char>(colour >> 8 | 0x80);
  }
}

/// True if words like -1.#IND and nan are among the next three.
bool has_words(std::string_view numbers) { return numbers.find_first_not_of(" \t\r0123456789+-.eE") != numbers.npos; }

std::string with_plain_normals(std::string_view text) {
  constexpr std::string_view kNormal = "normal ";
  std::string plain;
  for (std::size_t at = text.find(kNormal); at != text.npos; at = text.find(kNormal)) {
    at += kNormal.size();
    const std::string_view numbers = text.substr(at, text.find('\n', at) - at);
    plain += text.substr(0, at);
    plain += has_words(numbers) ? "0 0 0" : numbers;
    text.remove_prefix(at + numbers.size());
  }
  return plain.append(text);
}

}  // namespace

std::string plain_stl(std::string bytes) {
  const bool counted = bytes.size() >= kHeaderBytes && triangles_of(bytes) > 0;
  if (counted && triangles_of(bytes) <= (bytes.size() - kHeaderBytes) / kTriangleBytes) {
    bytes.resize(kHeaderBytes + kTriangleBytes * triangles_of(bytes));
    set_colours_of_magics(bytes);
    return bytes;
  }
  std::string_view text = bytes;
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.starts_with("solid") ? with_plain_normals(text) : bytes;
}

}  // namespace zstrip::sim
