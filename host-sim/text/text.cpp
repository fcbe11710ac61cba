// Words on the standard streams, where writing may fail: a full disk, a closed stream.
#include "text/text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace zstrip::sim {
namespace {

/// Returns the number of bytes of the first character in UTF-8; 1 if the bytes are not a character.
std::size_t length_of(std::string_view text) {
  const auto first = static_cast<std::uint8_t>(text[0]);
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
  const std::string_view rest = text.substr(1, length - 1);
  const bool whole = rest.size() + 1 == length &&
                     std::ranges::all_of(rest, [](char c) { return (static_cast<std::uint8_t>(c) & 0xC0) == 0x80; });
  return whole ? length : 1;
}

/// True if a terminal obeys the character instead of showing it: controls of ASCII and C1, ends of lines and
/// paragraphs, and marks that change the direction of text.
bool is_control(std::string_view character) {
  const auto first = static_cast<std::uint8_t>(character[0]);
  if (character.size() == 1) return first < 0x20 || first == 0x7F || (first >= 0x80 && first < 0xA0);
  char32_t code = first & (character.size() == 2 ? 0x1FU : 0xFU);
  for (const char c : character.substr(1)) code = code << 6 | (static_cast<std::uint8_t>(c) & 0x3FU);
  const auto within = [code](char32_t low, char32_t high) { return code >= low && code <= high; };
  return code < 0xA0 || code == 0x61C || within(0x200E, 0x200F) || within(0x2028, 0x202E) || within(0x2066, 0x2069);
}

}  // namespace

bool write_text(std::FILE* stream, std::string_view text) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  return std::fflush(stream) == 0 && whole;
}

std::string lower(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

std::string printable(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::string_view character = text.substr(0, length_of(text));
    line += is_control(character) ? std::string_view("?") : character;
    text.remove_prefix(character.size());
  }
  return line;
}

}  // namespace zstrip::sim
