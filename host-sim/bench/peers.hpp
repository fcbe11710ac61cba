// The cost of other renderers for the same workloads, for comparison.
#pragma once

#include <cstdint>
#include <string_view>

#include "bench/measurement.hpp"

namespace zstrip::sim {

/// Published here: all renderers on the same workloads, 60 frames each, GCC 12 -O2, including clears, without set-up,
/// drawing into whole buffers; boards are emulated like ours.
struct Peer {
  std::string_view name;
  double million_instructions;  ///< a frame
};

/// Returns the peer with the fewest instructions for the same workload, target and picture size; the name is null if
/// none was measured. Only rows of kPeerFrames frames can be compared: the model rotates, and frames differ.
inline constexpr std::uint32_t kPeerFrames = 60;
Peer best_peer(const BenchCase& bench_case);

}  // namespace zstrip::sim
