// The fuzzer's bytes as numbers. They are read in order and followed by endless zeros, so that every input means
// something, a short one something simple, and bytes added at the end keep the meaning of those before them.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fuzz {

class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}

  /// Any value, little endian.
  template <std::integral T>
  T any() {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) value |= std::uint64_t{byte()} << (8 * i);
    return static_cast<T>(value);
  }

  bool flag() { return (byte() & 1) != 0; }

  /// 0..limit - 1; 0 if limit is 0.
  std::uint32_t below(std::uint32_t limit) {
    if (limit <= 1) return 0;
    return (limit <= 256 ? any<std::uint8_t>() : limit <= 65536 ? any<std::uint16_t>() : any<std::uint32_t>()) % limit;
  }

  std::int32_t between(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(below(static_cast<std::uint32_t>(high - low) + 1));
  }

  /// `usual` for a zero byte; else small numbers, powers of two and their neighbours, the ends of the range, or any.
  std::int32_t number(std::int32_t usual) {
    switch (below(8)) {
      case 0: return usual;
      case 1: return any<std::int8_t>();
      case 2: return any<std::int16_t>();
      case 3: return any<std::int16_t>() * 256;
      case 4: return static_cast<std::int32_t>((1U << below(32)) + any<std::uint32_t>() % 5 - 2);
      case 5: return static_cast<std::int32_t>(~((1U << below(32)) + any<std::uint32_t>() % 5 - 2));
      case 6: return wrapping_sum(usual, any<std::int16_t>());
      default: return any<std::int32_t>();
    }
  }

 private:
  static std::int32_t wrapping_sum(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
  }
  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  std::span<const std::uint8_t> rest_;
};

}  // namespace fuzz
