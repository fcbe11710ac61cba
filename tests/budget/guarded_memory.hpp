// Memory of exactly so many bytes between guards: a write outside is noticed, and with AddressSanitizer any access.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zstrip::budget {

class GuardedMemory {
 public:
  /// `size` bytes of garbage, `misalignment` bytes behind an address that is a multiple of 8.
  explicit GuardedMemory(std::size_t size, std::size_t misalignment = 0);
  ~GuardedMemory();
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;

  std::span<std::byte> bytes() { return std::span(memory_).subspan(begin_, size_); }
  /// Whether an access outside ends the program (with AddressSanitizer); else writes are seen afterwards.
  static bool traps_access_outside();
  /// Whether nothing outside the bytes was written.
  bool guards_untouched();
  /// Whether not even the bytes were written. (They are garbage, which no picture is.)
  bool untouched();

 private:
  void close_guards();
  void open_guards();
  bool is_garbage(std::size_t from, std::size_t to) const;

  std::size_t begin_;
  std::size_t size_;
  std::vector<std::byte> memory_;
};

}  // namespace zstrip::budget
