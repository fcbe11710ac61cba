// Waiting, which start sequences of panels must.
#pragma once

#include <concepts>
#include <cstdint>

namespace zstrip::hal {

/// wait(microseconds) returns not earlier than that; how much later does not matter. Up to a second at a time. A board
/// may sleep, poll a timer or count loops.
template <class T>
concept Clock = requires(T& clock, std::uint32_t microseconds) {
  { clock.wait(microseconds) } -> std::same_as<void>;
};

}  // namespace zstrip::hal
