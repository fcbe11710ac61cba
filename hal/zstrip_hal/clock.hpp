// Delays, which the start sequences of panels need.
#pragma once

#include <concepts>
#include <cstdint>

namespace zstrip::hal {

/// wait(microseconds) returns after at least that time, at most one second per call. It may return later by any
/// amount. A board may sleep, poll a timer or count loops.
template <class T>
concept Clock = requires(T& clock, std::uint32_t microseconds) {
  { clock.wait(microseconds) } -> std::same_as<void>;
};

}  // namespace zstrip::hal
