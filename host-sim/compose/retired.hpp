// Removed settings, and the advice of error messages about them.
#pragma once

#include <string_view>
#include <utility>

namespace zstrip::sim {

/// Returns advice for a removed setting or value; empty if `word` never was one.
constexpr std::string_view instead_of(std::string_view word) {
  constexpr std::pair<std::string_view, std::string_view> kGone[] = {
      {"z32", "use z24"},
      {"w16", "use z24, or float where memory is short"},
      {"reciprocal", "leave it out: 1/w is always found to 2^-28"},
  };
  for (const auto& [gone, instead] : kGone) {
    if (word == gone) return instead;
  }
  return {};
}

}  // namespace zstrip::sim
