// The tags of an XML text, one after the other.
#include "import/3mf/xml_tags.hpp"

#include <algorithm>
#include <array>

namespace zstrip::sim {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";

std::string_view without_prefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

void skip_spaces(std::string_view& text) { text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size())); }

}  // namespace

bool XmlTag::has(std::string_view key) const {
  return std::ranges::any_of(attributes, [key](const auto& attribute) { return attribute.first == key; });
}

std::string XmlTag::value(std::string_view key) const {
  const auto found = std::ranges::find_if(attributes, [key](const auto& attribute) { return attribute.first == key; });
  if (found == attributes.end()) return {};
  constexpr std::array<std::pair<std::string_view, char>, 5> kReferences{
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string plain;
  std::string_view raw = found->second;
  while (!raw.empty()) {
    std::size_t taken = 1;
    char character = raw[0];
    for (const auto& [reference, stands_for] : kReferences) {
      if (!raw.starts_with(reference)) continue;
      taken = reference.size();
      character = stands_for;
    }
    plain += character;
    raw.remove_prefix(taken);
  }
  return plain;
}

void XmlTags::skip(std::string_view end) {
  const std::size_t at = rest_.find(end);
  rest_.remove_prefix(at == std::string_view::npos ? rest_.size() : at + end.size());
}

std::optional<XmlTag> XmlTags::next() {
  while (true) {
    skip("<");
    if (rest_.empty()) return std::nullopt;
    if (rest_.starts_with("!--")) {
      skip("-->");
    } else if (rest_.starts_with("![CDATA[")) {
      skip("]]>");
    } else if (rest_[0] == '!' || rest_[0] == '?') {
      skip(">");
    } else {
      break;
    }
  }
  XmlTag tag;
  if (rest_[0] == '/') {
    rest_.remove_prefix(1);
    tag.begins = false;
    tag.ends = true;
  }
  tag.name = rest_.substr(0, rest_.find_first_of(" \t\r\n/>"));
  rest_.remove_prefix(tag.name.size());
  tag.name = without_prefix(tag.name);
  while (true) {
    skip_spaces(rest_);
    if (rest_.empty()) return std::nullopt;
    if (rest_[0] == '>') {
      rest_.remove_prefix(1);
      return tag;
    }
    if (rest_[0] == '/') {
      tag.ends = true;
      rest_.remove_prefix(1);
      continue;
    }
    const std::string_view key = rest_.substr(0, rest_.find_first_of(" \t\r\n=/>"));
    rest_.remove_prefix(key.size());
    skip_spaces(rest_);
    if (key.empty() || !rest_.starts_with('=')) return std::nullopt;
    rest_.remove_prefix(1);
    skip_spaces(rest_);
    if (rest_.empty() || (rest_[0] != '"' && rest_[0] != '\'')) return std::nullopt;
    const char quote = rest_[0];
    rest_.remove_prefix(1);
    const std::string_view value = rest_.substr(0, rest_.find(quote));
    if (value.size() == rest_.size()) return std::nullopt;
    rest_.remove_prefix(value.size() + 1);
    tag.attributes.emplace_back(without_prefix(key), value);
  }
}

}  // namespace zstrip::sim
