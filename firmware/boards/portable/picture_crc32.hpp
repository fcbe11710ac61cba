// Computes the CRC-32 of a whole picture, as zlib does over all rows from top to bottom, from rectangles in any order.
// CRCs are polynomials over GF(2): the CRC of a picture is the sum of those of its parts, each times x^8 for every byte
// that follows the part in the picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "portable/crc32.hpp"

namespace zstrip::board {

/// Returns the product of two polynomials modulo that of the CRC, reflected: the highest bit is the coefficient of x^0.
constexpr std::uint32_t crc32_product(std::uint32_t a, std::uint32_t b) {
  std::uint32_t result = 0;
  for (; a != 0; a <<= 1) {
    if ((a & 0x80000000U) != 0) result ^= b;
    b = (b >> 1) ^ ((b & 1U) != 0 ? Crc32::kPolynomial : 0);
  }
  return result;
}

class PictureCrc32 {
 public:
  explicit constexpr PictureCrc32(std::uint32_t picture_bytes) : picture_bytes_(picture_bytes) {}

  /// Adds adjacent bytes of the picture, `offset` bytes from its begin. They must lie in the picture, and no byte may
  /// be added twice.
  void add(std::uint32_t offset, std::span<const std::byte> bytes) {
    Crc32 part(0);
    part.add(bytes);
    const auto size = static_cast<std::uint32_t>(bytes.size());
    sum_ ^= followed_by(part.state(), picture_bytes_ - offset - size);
    added_ += size;
  }
  bool complete() const { return added_ == picture_bytes_; }
  std::uint32_t value() const { return ~(sum_ ^ followed_by(0xFFFFFFFF, picture_bytes_)); }

 private:
  /// x^8, followed by the square of each entry before: the factor for 2^i zero bytes.
  static constexpr std::array<std::uint32_t, 32> kPowers = [] {
    std::array<std::uint32_t, 32> powers{};
    std::uint32_t power = 0x80000000U >> 8;
    for (std::uint32_t& each : powers) {
      each = power;
      power = crc32_product(power, power);
    }
    return powers;
  }();

  /// Returns the state after this number of zero bytes.
  static std::uint32_t followed_by(std::uint32_t state, std::uint32_t bytes) {
    for (std::size_t bit = 0; bytes != 0; ++bit, bytes >>= 1) {
      if ((bytes & 1U) != 0) state = crc32_product(kPowers[bit], state);
    }
    return state;
  }

  std::uint32_t picture_bytes_;
  std::uint32_t added_ = 0;
  std::uint32_t sum_ = 0;
};

}  // namespace zstrip::board
