// Functions in assembly against the C++ that they stand for.
#pragma once

#include <cstdint>

namespace zstrip::board {

/// Pseudo-random triangles, runs of texels, meshlets and vertices, both ways: what is in memory afterwards is
/// compared word by word. 0 if all are equal; says what differs. A core without assembly has nothing to compare, which
/// it says.
int check_small_triangles();
int check_textured_runs();
int check_small_runs();
int check_transform();

/// Marsaglia's xorshift.
class Random {
 public:
  std::uint32_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    return state_ ^= state_ << 5;
  }
  std::int32_t below(std::int32_t limit) { return static_cast<std::int32_t>(next() >> 1) % limit; }

 private:
  std::uint32_t state_ = 0x2545F491;
};

}  // namespace zstrip::board
