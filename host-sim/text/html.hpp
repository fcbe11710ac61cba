// Text and pictures inside of HTML files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace zstrip::sim {

/// Replaces the characters that HTML gives a meaning.
std::string escaped(std::string_view text);

/// Returns the address of a picture that is part of the page.
std::string data_url(std::span<const std::uint8_t> png);

}  // namespace zstrip::sim
