// A set-associative cache of the least recently used lines, in front of a microcontroller's flash.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace zstrip::sim {

class FlashCache {
 public:
  /// `lines` of `line_bytes` (a power of two) in sets of `ways`, which divides `lines`; no lines: every read misses.
  FlashCache(std::uint32_t lines, std::uint32_t ways, std::uint32_t line_bytes)
      : ways_(ways), line_bytes_(line_bytes), tags_(lines, kEmpty) {}

  std::uint32_t line_of(std::uint32_t address) const { return address / line_bytes_; }

  /// Returns true if the line was in the cache; makes it the most recently used line of its set.
  bool touch(std::uint32_t line) {
    if (tags_.empty()) return false;
    const std::size_t sets = tags_.size() / ways_;
    const auto first = tags_.begin() + static_cast<std::ptrdiff_t>(line % sets * ways_);
    const auto end = first + ways_;
    const auto found = std::find(first, end, line);
    const bool hit = found != end;
    std::rotate(first, hit ? found : end - 1, hit ? found + 1 : end);
    *first = line;
    return hit;
  }

 private:
  static constexpr std::uint32_t kEmpty = 0xFFFFFFFF;
  std::uint32_t ways_;
  std::uint32_t line_bytes_;
  std::vector<std::uint32_t> tags_;  // each set in the order from the most to the least recently used
};

}  // namespace zstrip::sim
