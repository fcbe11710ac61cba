// Parses the set of characters of a font as the user writes it, such as "A-Za-z0-9".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "result.hpp"

namespace zstrip::sim {

/// Returns code points, ascending, each once. A '-' between two characters is the range between them, and a '-' at
/// other places is the character itself. The failure's message continues "--characters ...".
Result<std::vector<std::uint32_t>> parse_characters(const std::string& text);

/// Returns the code points of text in UTF-8; empty if a byte begins no character.
std::vector<std::uint32_t> code_points_of(const std::string& text);

/// Returns the name for messages: "U+00C4".
std::string name_of_character(std::uint32_t code_point);

}  // namespace zstrip::sim
