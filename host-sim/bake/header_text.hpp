// The text of a baked header while it is written, and the names of the arrays in it.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "bake/literals.hpp"

namespace zstrip::sim {

class HeaderText {
 public:
  void add(std::string_view text) { text_ += text; }
  void line(std::string_view text) {
    text_ += text;
    text_ += '\n';
  }

  /// Writes an array of these records unless it is empty; returns the expression that refers to it.
  template <class Record>
  std::string array(const std::string& type, const std::string& name, std::span<const Record> records) {
    if (records.empty()) return "{}";
    const auto [known, is_new] = arrays_.try_emplace({records.data(), records.size()}, name);
    if (!is_new) return known->second;  // meshes of other sizes share their vertices
    text_ += array_definition(type, name, records);
    return name;
  }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
  std::map<std::pair<const void*, std::size_t>, std::string> arrays_;  ///< names of the arrays that were written
};

}  // namespace zstrip::sim
