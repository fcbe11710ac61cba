// Causes a fault instead of showing a picture, to test the board's report.
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
