// A case of the benchmark, and one row of results: a workload on a target with one picture size and memory plan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "zstrip/plan.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// The settings of one row of `zstrip bench`.
struct BenchCase {
  std::string workload;  ///< as in workloads.cpp
  std::string target;    ///< "host", "m0", "m3", "m4f", "m7", "m33", "m55" or "rv32"
  View view;
  Budget budget;              ///< zeros: the planner decides
  std::string depth = "z16";  ///< depth format or method; other values than z16 only on boards, for R50: see
                              ///< firmware/README.md
  std::uint32_t frames = 0;
  bool in_turns = false;     ///< for a board: strips in the order of two cores, every other strip, then the strips
                             ///< between
  std::string program{};     ///< for a board: program without folder and suffix, used in place of the benchmark's
  std::string scene_file{};  ///< a baked scene (.zsc) for such a program
};

struct Measurement {
  BenchCase bench_case;
  Mode mode = Mode::streamed;
  std::uint16_t strip_rows = 0;
  std::uint16_t strip_columns = 0;
  std::uint64_t ram_bytes = 0;                            ///< arena, one strip of pixels, posed data
  std::optional<std::uint64_t> flash_bytes{};             ///< of the whole program; boards only
  std::optional<double> nanoseconds_per_frame{};          ///< host only: emulated time is not time
  std::optional<std::uint64_t> instructions_per_frame{};  ///< nothing if they could not be counted
  std::vector<std::uint32_t> frame_crc32{};               ///< zlib's CRC-32 of each frame's pixels, strips as drawn
};

}  // namespace zstrip::sim
