// Estimates the frames a second of a board from the instructions that the planner estimates, without an emulator.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/board_model.hpp"
#include "bench/strip_timeline.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// A frame as the planner estimates it.
struct EstimatedFrame {
  Plan plan;
  View view;
  std::uint64_t instructions = 0;  ///< of a Cortex-M3
  std::optional<double> cycles{};  ///< of the board, if they are known better than by its cycles an instruction
};

struct BoardTime {
  double draw, send;  // seconds, for the whole frame
};

/// `cycles`: for an instruction of the estimate.
BoardTime time_on(const BoardModel& board, double cycles, double bus_mhz, const EstimatedFrame& frame);
/// Returns the times of each strip: its share of the frame's pixels.
std::vector<StripTimes> times_on(const BoardModel& board, double cycles, double bus_mhz, const EstimatedFrame& frame);

/// The approximate number of frames that a board shows in a second, with its own bus; or its memory does not suffice.
struct BoardRate {
  std::string_view board;
  double least = 0, most = 0;    ///< 0: the plan does not fit
  std::uint64_t needed_ram = 0;  ///< bytes: arena, strip buffers and kReservedRam
  bool fits() const { return most > 0; }
  /// Returns "12.3", "8 to 17" where the core has no model, or "needs 28 KB".
  std::string words() const;
};
BoardRate rate_on(const BoardModel& board, double bus_mhz, const EstimatedFrame& frame);

std::vector<Rect> strips_of(const Plan& plan, const View& view);

}  // namespace zstrip::sim
