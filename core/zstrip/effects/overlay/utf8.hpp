// Decodes UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace zstrip::detail {

/// A value that is not a code point.
inline constexpr std::uint32_t kNoCodePoint = 0xFFFFFFFF;

/// Removes the first code point from a text that is not empty, and returns it. If a byte begins no valid sequence (cut
/// off, overlong, a surrogate, beyond U+10FFFF), removes only this byte and returns kNoCodePoint.
constexpr std::uint32_t take_code_point(std::span<const char>& text) {
  const auto byte = [&text](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(text[i])}; };
  const std::uint32_t lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  std::uint32_t point = length == 1 ? lead : lead & (0x7FU >> length);
  bool valid = (lead < 0x80 || lead >= 0xC2) && lead < 0xF5 && length <= text.size();
  for (std::size_t i = 1; valid && i < length; ++i) {
    valid = (byte(i) & 0xC0U) == 0x80;
    point = point << 6 | (byte(i) & 0x3FU);
  }
  if (length == 3) valid = valid && point >= 0x800 && (point < 0xD800 || point > 0xDFFF);
  if (length == 4) valid = valid && point >= 0x10000 && point <= 0x10FFFF;
  text = text.subspan(valid ? length : 1);
  return valid ? point : kNoCodePoint;
}

}  // namespace zstrip::detail
