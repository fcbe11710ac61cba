// Words on the standard streams, where writing may fail: a full disk, a closed stream.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace zstrip::sim {

/// Writes the text and flushes; false if not all of it went out. Never throws.
bool write_text(std::FILE* stream, std::string_view text);

/// Returns the text with ASCII's upper case letters in lower case.
std::string lower(std::string text);

/// Returns the text in UTF-8, with '?' for each control character and each mark that changes the direction of text:
/// names of files may contain them.
std::string printable(std::string_view text);

}  // namespace zstrip::sim
