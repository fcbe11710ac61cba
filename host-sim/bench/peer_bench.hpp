// Other renderers on the same workloads, on this machine, in the same run.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

struct PeerRow {
  std::string workload;
  std::string renderer;  ///< "zstrip", or the other's name
  std::uint16_t width = 0, height = 0;
  double nanoseconds_per_frame = 0;                       ///< median of the rounds
  std::optional<std::uint64_t> instructions_per_frame{};  ///< absent where valgrind cannot count them
  std::uint64_t covered = 0;                              ///< pixels of frame 0 that differ from the background's
                                                          ///< colour
};

struct PeerComparison {
  std::vector<PeerRow> rows;         ///< zstrip is the first of each workload
  std::vector<std::string> skipped;  ///< renderers that are not installed, and why
};

/// The renderers alternate: in each round every renderer draws every case once. All draw into whole buffers of RGB565
/// with 16 bits of depth (Allegro: a float), on one thread. A renderer whose covered pixels differ from ours by more
/// than a fiftieth is a failure with ExitStatus::internal, because it has not done the same work.
Result<PeerComparison> compare_with_peers(const std::vector<BenchCase>& cases);

/// Returns one line for each row, with the ratios of the other renderers to zstrip.
std::string peer_table(const PeerComparison& comparison);
/// Returns an array with one object for each row; bench/README.md documents the keys.
std::string peer_json(const PeerComparison& comparison);

}  // namespace zstrip::sim
