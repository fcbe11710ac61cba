// Composes text in an array, without a C library. Text that does not fit is left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace zstrip::detail {

/// The text in the array always ends with a byte of 0.
class Words {
 public:
  explicit Words(std::span<char> to, std::size_t size = 0) : to_(to), size_(size) { to_[size_] = 0; }

  Words& operator<<(const char* text) {
    for (; *text != 0 && size_ + 1 < to_.size(); ++text) to_[size_++] = *text;
    to_[size_] = 0;
    return *this;
  }
  Words& operator<<(std::uint32_t number) {
    char digits[11]{};
    char* first = digits + 10;
    do {
      *--first = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number != 0);
    return *this << first;
  }

 private:
  std::span<char> to_;
  std::size_t size_;
};

}  // namespace zstrip::detail
