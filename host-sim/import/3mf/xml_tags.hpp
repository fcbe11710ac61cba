// The tags of an XML text, one after the other.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace zstrip::sim {

struct XmlTag {
  std::string_view name;  ///< without the prefix of a namespace
  bool begins = true;     ///< the tag begins an element
  bool ends = false;      ///< the tag ends an element; an empty element has one tag for both
  std::vector<std::pair<std::string_view, std::string_view>> attributes;  ///< names without prefix, and raw values

  /// Returns the value of an attribute, its references replaced; empty if there is none.
  std::string value(std::string_view key) const;
  bool has(std::string_view key) const;
};

/// Text between tags, comments, instructions and declarations are skipped. Anything that is not XML ends the text.
class XmlTags {
 public:
  explicit XmlTags(std::string_view text) : rest_(text) {}

  /// Returns the next tag, which refers to the text; empty at the end.
  std::optional<XmlTag> next();

 private:
  /// Skips these characters and all text before them.
  void skip(std::string_view end);

  std::string_view rest_;
};

}  // namespace zstrip::sim
