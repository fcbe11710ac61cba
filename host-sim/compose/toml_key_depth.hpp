// How deep the keys of a .toml text lead: to be asked before a parser that calls itself for each level reads it.
#pragma once

#include <optional>
#include <string_view>

namespace zstrip::sim {

/// Names in one key, as a.b.c has three. Scene files need two.
inline constexpr int kMaxKeyNames = 16;

/// The line of the first key with more names, in a heading or before its value; empty if there is none. What is not
/// TOML at all is for the parser to refuse: keys behind it may be missed.
std::optional<int> line_of_deep_key(std::string_view text);

}  // namespace zstrip::sim
