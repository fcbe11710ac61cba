// Hashes and moves rows of pixels, by words of four bytes where they are aligned.
#include "zstrip_hal/changed_tiles.hpp"

#include <bit>

namespace zstrip::hal::detail {
namespace {

bool is_aligned(const std::byte* at) { return reinterpret_cast<std::uintptr_t>(at) % 4 == 0; }

/// `at` is aligned.
std::uint32_t word_at(const std::byte* at) {
  std::uint32_t word = 0;
  __builtin_memcpy(&word, __builtin_assume_aligned(at, 4), sizeof word);
  return word;
}

/// Both a rotation and a product with an odd number lose nothing. The rotation lets high bits reach low ones, which a
/// product does not.
std::uint32_t mixed(std::uint32_t hash, std::uint32_t word, std::uint32_t factor) {
  return (std::rotl(hash, 5) ^ word) * factor;
}

}  // namespace

std::uint32_t hash_rows(std::uint32_t place, const std::byte* pixels, std::uint32_t bytes, std::uint32_t stride,
                        std::uint32_t rows) {
  std::uint32_t factor = 0x9E3779B1U;  // a prime near 2^32 by the golden ratio
  asm("" : "+r"(factor));  // GCC would replace the product by 15 shifts and sums where multipliers may be slow
  std::uint32_t hash = mixed(place, bytes << 16 | rows, factor);
  for (; rows > 0; --rows, pixels += stride) {
    const std::byte* at = pixels;
    const std::byte* const end = at + bytes;
    if (is_aligned(at)) {
      // Two words a step: a step has a compare and a branch.
      for (const std::byte* const pairs = at + bytes / 8 * 8; at != pairs; at += 8) {
        hash = mixed(mixed(hash, word_at(at), factor), word_at(at + 4), factor);
      }
    }
    for (; at != end; ++at) hash = mixed(hash, std::to_integer<std::uint32_t>(*at), factor);
  }
  return hash == 0 ? 1 : hash;
}

void pack_rows(const std::byte* from, std::byte* to, std::uint32_t bytes, std::uint32_t stride, std::uint32_t rows) {
  for (; rows > 0; --rows, from += stride, to += bytes) {
    std::uint32_t at = 0;
    if (is_aligned(from) && is_aligned(to)) {
      for (; at + 4 <= bytes; at += 4) {
        const std::uint32_t word = word_at(from + at);
        __builtin_memcpy(__builtin_assume_aligned(to + at, 4), &word, sizeof word);
      }
    }
    for (; at < bytes; ++at) to[at] = from[at];
  }
}

}  // namespace zstrip::hal::detail
