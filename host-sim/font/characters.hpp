// Which characters a font is to have, as people write it: "A-Za-z0-9" and what else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "result.hpp"

namespace zstrip::sim {

/// Code points, ascending, each once. A '-' between two characters is all from the one to the other, elsewhere itself.
/// The failure's message continues "--characters ...".
Result<std::vector<std::uint32_t>> parse_characters(const std::string& text);

/// Of text in UTF-8; empty where a byte begins no character.
std::vector<std::uint32_t> code_points_of(const std::string& text);

/// As it is written in messages: "U+00C4".
std::string name_of_character(std::uint32_t code_point);

}  // namespace zstrip::sim
