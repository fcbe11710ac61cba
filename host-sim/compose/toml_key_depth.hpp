// Checks the depth of keys in a .toml text, before a recursive parser reads it.
#pragma once

#include <optional>
#include <string_view>

namespace zstrip::sim {

/// Number of names in one key: a.b.c has three. Scene files need two.
inline constexpr int kMaxKeyNames = 16;

/// Returns the line of the first key with more names, in a heading or before its value; empty if there is none. The
/// parser refuses text that is not TOML; keys after it may be missed.
std::optional<int> line_of_deep_key(std::string_view text);

}  // namespace zstrip::sim
