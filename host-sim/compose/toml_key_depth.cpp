// Counts the dots of keys. Dots in texts and comments do not count, so that these are skipped by the rules of TOML 1.0.
#include "compose/toml_key_depth.hpp"

#include <algorithm>
#include <cstddef>

namespace zstrip::sim {
namespace {

/// Returns the position after the text whose first quote is at `at`, or after the line or file if the text does not
/// end.
std::size_t behind_text(std::string_view text, std::size_t at) {
  constexpr int kOwnQuotes = 2;  // quotes of a text with three quotes directly before its end
  const char quote = text[at];
  const bool has_escapes = quote == '"';
  const std::string_view three = has_escapes ? "\"\"\"" : "'''";
  const bool has_lines = text.substr(at).starts_with(three);
  for (at += has_lines ? three.size() : 1; at < text.size(); ++at) {
    if (has_escapes && text[at] == '\\') {
      ++at;
    } else if (has_lines && text.substr(at).starts_with(three)) {
      at += three.size();
      for (int more = 0; more < kOwnQuotes && at < text.size() && text[at] == quote; ++more) ++at;
      return at;
    } else if (!has_lines && (text[at] == quote || text[at] == '\n')) {
      return text[at] == quote ? at + 1 : at;
    }
  }
  return text.size();
}

}  // namespace

std::optional<int> line_of_deep_key(std::string_view text) {
  int names = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = behind_text(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '.') {
      if (++names > kMaxKeyNames) return 1 + static_cast<int>(std::ranges::count(text.substr(0, at), '\n'));
    } else if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) {
      names = 1;
    }
    ++at;
  }
  return std::nullopt;
}

}  // namespace zstrip::sim
