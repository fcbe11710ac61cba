// CRC-32 as zlib computes it (reflected polynomial 0xEDB88320), in pieces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace zstrip::board {

class Crc32 {
 public:
  static constexpr std::uint32_t kPolynomial = 0xEDB88320;

  explicit constexpr Crc32(std::uint32_t state = 0xFFFFFFFF) : state_(state) {}
  void add(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      state_ = (state_ >> 8) ^ kTable[(state_ ^ std::to_integer<std::uint32_t>(byte)) & 0xFFU];
    }
  }
  std::uint32_t value() const { return ~state_; }
  std::uint32_t state() const { return state_; }  ///< not inverted, for computing with CRCs

 private:
  static constexpr std::array<std::uint32_t, 256> kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t index = 0; index < 256; ++index) {
      std::uint32_t remainder = index;
      for (int bit = 0; bit < 8; ++bit) remainder = (remainder >> 1) ^ ((remainder & 1U) != 0 ? kPolynomial : 0);
      table[index] = remainder;
    }
    return table;
  }();
  std::uint32_t state_;
};

}  // namespace zstrip::board
