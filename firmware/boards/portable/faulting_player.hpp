// Faults instead of showing anything, for tests of what a board reports then.
#pragma once

#include <cstdint>

#include "portable/failure.hpp"

namespace zstrip::board {

struct FaultingPlayer {
  static constexpr std::uint32_t kFrames = 1;
  template <class Panel>
  static Failure show(Panel&, std::uint32_t) {
    __builtin_trap();
    return {};
  }
};

}  // namespace zstrip::board
