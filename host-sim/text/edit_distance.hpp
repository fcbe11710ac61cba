// The difference between two words, for "did you mean".
#pragma once

#include <cstddef>
#include <string_view>

namespace zstrip::sim {

/// The fewest bytes inserted, deleted or replaced that make `to` of `from` (Levenshtein 1966).
std::size_t edit_distance(std::string_view from, std::string_view to);

}  // namespace zstrip::sim
