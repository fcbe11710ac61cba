// The random numbers of the benchmarks' workloads.
#pragma once

#include <cstdint>

namespace zstrip::scenes {

/// Marsaglia's xorshift32 (13, 17, 5).
class WorkloadRandom {
 public:
  constexpr explicit WorkloadRandom(std::uint32_t seed) : state_(seed) {}

  constexpr std::uint32_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }

 private:
  std::uint32_t state_;
};

}  // namespace zstrip::scenes
