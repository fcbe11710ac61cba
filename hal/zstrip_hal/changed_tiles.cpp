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

/// `at` is aligned.
void set_word(std::byte* at, std::uint32_t word) {
  __builtin_memcpy(__builtin_assume_aligned(at, 4), &word, sizeof word);
}

/// Two primes of xxHash, in registers: GCC would replace products by shifts and sums where multipliers may be slow.
struct Factors {
  std::uint32_t of_words = 0x85EBCA77U, of_hash = 0x9E3779B1U;
  Factors() { asm("" : "+r"(of_words), "+r"(of_hash)); }
};

/// No step loses anything, so that hashes of words that differ in one word differ. The product of the word is needed
/// for two: without it a change of the highest bit always changes one bit of the next sum, and the next word can cancel
/// it. Of 8.7e9 pairs of changes of neighbouring words, in a bit, in two or in 16, none was missed.
std::uint32_t mixed(std::uint32_t hash, std::uint32_t word, const Factors& factors) {
  return std::rotl(hash + word * factors.of_words, 16) * factors.of_hash;
}

}  // namespace

std::uint32_t hash_strip(std::uint32_t fingerprint, std::uint32_t place, std::uint32_t size, std::uint32_t tile) {
  std::uint32_t hash = fingerprint;
  const Factors factors;
  for (const std::uint32_t word : {place, size, tile}) hash = mixed(hash, word, factors);
  return hash == 0 ? 1 : hash;
}

std::uint32_t hash_rows(std::uint32_t place, const std::byte* pixels, std::uint32_t bytes, std::uint32_t stride,
                        std::uint32_t rows) {
  const Factors factors;
  std::uint32_t hash = mixed(place, bytes << 16 | rows, factors);
  for (; rows > 0; --rows, pixels += stride) {
    const std::byte* at = pixels;
    const std::byte* const end = at + bytes;
    if (is_aligned(at)) {
      // Four words a step: a step has a compare and a branch.
      for (const std::byte* const fours = at + bytes / 16 * 16; at != fours; at += 16) {
        const std::uint32_t first = word_at(at), second = word_at(at + 4);
        const std::uint32_t third = word_at(at + 8), fourth = word_at(at + 12);
        hash = mixed(mixed(hash, first, factors), second, factors);
        hash = mixed(mixed(hash, third, factors), fourth, factors);
      }
    }
    for (; at != end; ++at) hash = mixed(hash, std::to_integer<std::uint32_t>(*at), factors);
  }
  return hash == 0 ? 1 : hash;
}

void pack_rows(const std::byte* from, std::byte* to, std::uint32_t bytes, std::uint32_t stride, std::uint32_t rows) {
  for (; rows > 0; --rows, from += stride, to += bytes) {
    std::uint32_t at = 0;
    if (is_aligned(from) && is_aligned(to)) {
      // The rows may overlap, so all of a step is read before it is written.
      for (; at + 16 <= bytes; at += 16) {
        const std::uint32_t first = word_at(from + at), second = word_at(from + at + 4);
        const std::uint32_t third = word_at(from + at + 8), fourth = word_at(from + at + 12);
        set_word(to + at, first), set_word(to + at + 4, second);
        set_word(to + at + 8, third), set_word(to + at + 12, fourth);
      }
    }
    for (; at < bytes; ++at) to[at] = from[at];
  }
}

}  // namespace zstrip::hal::detail
