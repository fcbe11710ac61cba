// Words on the standard streams, where writing may fail: a full disk, a closed stream.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace zstrip::sim {

/// Writes the text and flushes; false if not all of it went out. Never throws.
bool write_text(std::FILE* stream, std::string_view text);

/// Control characters, which names of files may hold, as '?'.
std::string printable(std::string_view text);

}  // namespace zstrip::sim
