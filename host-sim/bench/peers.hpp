// What other renderers need for the same workloads: figures to compare with.
#pragma once

#include <cstdint>
#include <string_view>

#include "bench/measurement.hpp"

namespace zstrip::sim {

/// Published here: measured side by side on the same workloads, 60 frames each, GCC 12 -O2, clears included, set-up
/// excluded, drawing into whole buffers; boards emulated like ours.
struct Peer {
  std::string_view name;
  double million_instructions;  ///< a frame
};

/// The peer with the fewest instructions for the same workload, target and picture size; null name if none was
/// measured. Only rows of kPeerFrames frames can be compared: the model turns, and frames differ.
inline constexpr std::uint32_t kPeerFrames = 60;
Peer best_peer(const BenchCase& bench_case);

}  // namespace zstrip::sim
