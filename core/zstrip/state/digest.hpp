// A number for all that pixels depend on, to compare it with that of another frame.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// The digest of a sequence of words. Its steps lose nothing: digests of words that differ in one place differ; others
/// are equal with a probability of about 2^-32, also if only a few bits of neighbouring words differ.
class Digest {
 public:
  constexpr explicit Digest(std::uint32_t seed) : value_(seed) {}
  static constexpr std::uint32_t kNever = 0;
  /// Returns the digest of all words, never kNever.
  std::uint32_t value() const { return value_ == kNever ? 1 : value_; }

  void add(std::uint32_t word) {
    std::uint32_t of_words = 0x85EBCA77U, of_value = 0x9E3779B1U;  // primes of xxHash
    // GCC would replace products by shifts and sums where multipliers may be slow.
    asm("" : "+r"(of_words), "+r"(of_value));
    value_ = std::rotl(value_ + word * of_words, 16) * of_value;
  }
  template <std::signed_integral T>
  void add(T value) {
    add(static_cast<std::uint32_t>(value));
    if constexpr (sizeof value > sizeof(std::uint32_t)) add(static_cast<std::uint32_t>(value >> 32));
  }
  void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
  void add(const Colour& c) {
    add(std::uint32_t{c.r} | std::uint32_t{c.g} << 8U | std::uint32_t{c.b} << 16U | std::uint32_t{c.a} << 24U);
  }
  /// Adds the bytes of the elements, and with them addresses of further tables. Gaps in them are the caller's and
  /// stay as they are; if one does not, the digest differs for nothing.
  template <class T>
  void add_all(std::span<const T> table) {
    const auto* const bytes = reinterpret_cast<const std::byte*>(table.data());
    add(static_cast<std::uint32_t>(table.size()));
    if constexpr (alignof(T) % sizeof(std::uint32_t) == 0) {
      add_words(bytes, table.size_bytes() / sizeof(std::uint32_t));
    } else {
      add_bytes(bytes, table.size_bytes());
    }
  }
  template <class T>
  void add_one(const T* element) {
    add_all(std::span(element, element == nullptr ? 0 : 1));
  }

 private:
  // Not inlined: each is called for many tables.
  [[gnu::noinline]] void add_words(const std::byte* at, std::size_t count) {
    for (; count > 0; --count, at += sizeof(std::uint32_t)) {
      std::uint32_t word = 0;
      __builtin_memcpy(&word, __builtin_assume_aligned(at, sizeof word), sizeof word);
      add(word);
    }
  }
  [[gnu::noinline]] void add_bytes(const std::byte* at, std::size_t count) {
    for (; count > 0; --count, ++at) add(std::to_integer<std::uint32_t>(*at));
  }

  std::uint32_t value_;
};

}  // namespace zstrip::detail
