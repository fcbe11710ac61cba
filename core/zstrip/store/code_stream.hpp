// Reads and writes codes of any width in a record, most significant bit first.
#pragma once

#include <cstddef>
#include <cstdint>

namespace zstrip::detail {

/// Reads zeros after the end of the record; bytes_used() shows this.
class CodeReader {
 public:
  CodeReader(const std::uint8_t* first, const std::uint8_t* end) : first_(first), next_(first), end_(end) {}

  /// Returns the next code, unsigned. 1 <= width <= 16.
  std::uint32_t code(std::uint32_t width) {
    refill(width);
    const std::uint32_t value = bits_ >> (32 - width);
    consume(width);
    return value;
  }
  /// Returns the next code, in two's complement. 1 <= width <= 16.
  std::int32_t signed_code(std::uint32_t width) {
    refill(width);
    const std::int32_t value = static_cast<std::int32_t>(bits_) >> (32 - width);
    consume(width);
    return value;
  }

  /// Returns the bytes from which a bit was taken; more than the record has if codes were missing.
  std::size_t bytes_used() const { return static_cast<std::size_t>(next_ - first_) + missing_ - available_ / 8; }

 private:
  void refill(std::uint32_t width) {
    if (available_ >= width) return;
    std::uint32_t two_bytes = 0;
    if (end_ - next_ >= 2) {
      two_bytes = std::uint32_t{next_[0]} << 8 | next_[1];
      next_ += 2;
    } else {
      missing_ += 2;
      if (next_ != end_) {
        two_bytes = std::uint32_t{*next_++} << 8;
        --missing_;
      }
    }
    bits_ |= two_bytes << (16 - available_);  // available_ < width <= 16
    available_ += 16;
  }
  void consume(std::uint32_t width) {
    bits_ <<= width;
    available_ -= width;
  }

  const std::uint8_t* first_;
  const std::uint8_t* next_;
  const std::uint8_t* end_;
  std::uint32_t bits_ = 0;       ///< unread bits, from the highest bit on
  std::uint32_t available_ = 0;  ///< number of unread bits
  std::uint32_t missing_ = 0;    ///< bytes read after the end
};

/// The codes must fit into the record.
class CodeWriter {
 public:
  explicit CodeWriter(std::uint8_t* next) : next_(next) {}

  /// Appends the low `width` bits of `code`; 0 <= width <= 16.
  void append(std::uint32_t code, std::uint32_t width) {
    bits_ = bits_ << width | (code & ((std::uint32_t{1} << width) - 1));
    for (pending_ += width; pending_ >= 8; pending_ -= 8) {
      *next_++ = static_cast<std::uint8_t>(bits_ >> (pending_ - 8));
    }
  }
  /// Fills the last byte with zeros; returns the address after it.
  std::uint8_t* finish() {
    if (pending_ > 0) append(0, 8 - pending_);
    return next_;
  }

 private:
  std::uint8_t* next_;
  std::uint32_t bits_ = 0;
  std::uint32_t pending_ = 0;  ///< number of bits in bits_ that are not written yet
};

}  // namespace zstrip::detail
