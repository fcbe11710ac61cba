// What is measured, and one row of results: a workload on a target at one picture size and memory plan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "zstrip/plan.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// What the caller of `zstrip bench` chose for one row.
struct BenchCase {
  std::string workload;  ///< as in workloads.cpp
  std::string target;    ///< "host", "m0", "m3", "m4f", "m7", "m33", "m55" or "rv32"
  View view;
  Budget budget;              ///< zeros: the planner decides
  std::string depth = "z16";  ///< how depth is kept; anything else on boards only, of R50: see firmware/README.md
  std::uint32_t frames = 0;
  bool in_turns = false;     ///< of a board: strips as two cores draw them, every other one, then those between
  std::string program{};     ///< of a board, without folder and suffix, instead of the benchmark's
  std::string scene_file{};  ///< a baked scene (.zsc) for such a program
};

struct Measurement {
  BenchCase bench_case;
  Mode mode = Mode::streamed;
  std::uint16_t strip_rows = 0;
  std::uint16_t strip_columns = 0;
  std::uint64_t ram_bytes = 0;                            ///< arena, one strip of pixels, what is posed
  std::optional<std::uint64_t> flash_bytes{};             ///< of the whole program; boards only
  std::optional<double> nanoseconds_per_frame{};          ///< host only: emulated time is not time
  std::optional<std::uint64_t> instructions_per_frame{};  ///< absent where nothing could count them
  std::vector<std::uint32_t> frame_crc32{};               ///< zlib's CRC-32 of each frame's pixels, strips as drawn
};

}  // namespace zstrip::sim
