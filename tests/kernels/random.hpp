// Pseudo-random numbers of the contracts: the same on all processors.
#pragma once

#include <cstdint>

#include "zstrip/scene.hpp"

namespace zstrip::kernels_test {

/// Marsaglia's xorshift.
class Random {
 public:
  explicit Random(std::uint32_t seed) : state_((seed * 0x9E3779B9) | 1) {
    for (int i = 0; i < 8; ++i) word();
  }

  std::uint32_t word() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    return state_ ^= state_ << 5;
  }
  /// 0 .. limit - 1.
  std::int32_t below(std::int32_t limit) { return static_cast<std::int32_t>((word() >> 1) % unsigned_of(limit)); }
  std::int32_t between(std::int32_t low, std::int32_t high) { return low + below(high - low + 1); }
  /// -limit .. limit - 1.
  std::int32_t within(std::int32_t limit) { return between(-limit, limit - 1); }
  /// Channels are often at the ends of their range, where things wrap.
  Colour colour() {
    const std::uint32_t bits = word();
    const auto channel = [bits](int i) {
      const auto kind = (bits >> (24 + 2 * i)) & 3U;
      return static_cast<std::uint8_t>(kind == 0 ? 0U : kind == 1 ? 255U : (bits >> (8 * i)) & 255U);
    };
    return {channel(0), channel(1), channel(2), 255};
  }

 private:
  static constexpr std::uint32_t unsigned_of(std::int32_t value) { return static_cast<std::uint32_t>(value); }

  std::uint32_t state_;
};

}  // namespace zstrip::kernels_test
