// Words on the standard streams, where writing may fail: a full disk, a closed stream.
#include "report/text.hpp"

#include <algorithm>

namespace zstrip::sim {

bool write_text(std::FILE* stream, std::string_view text) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  return std::fflush(stream) == 0 && whole;
}

std::string printable(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return line;
}

}  // namespace zstrip::sim
