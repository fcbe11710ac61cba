// Writes a font as a C++ header of constants.
#pragma once

#include <string>

#include "zstrip/overlay.hpp"

namespace zstrip::sim {

/// `source`: name of the source, for a comment.
std::string to_font_header(const Font& font, const std::string& source, const std::string& name_space);

}  // namespace zstrip::sim
