// Real boards: core, clock, flash, memory and the bus to a display.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "bench/cycle_model.hpp"

namespace zstrip::sim {

/// Cycles of a core for each instruction that `zstrip plan` estimates for a Cortex-M3.
struct CyclesPerEstimate {
  double low, high;
};

struct BoardModel {
  std::string_view name;         ///< on the command line
  std::string_view description;  ///< board and chip
  std::string_view core{};    ///< of find_core(); empty: there is no model of the core, `zstrip bench` does not know it
  std::string_view target{};  ///< target whose programs run on the board: "m0", "m3", "m4f", "m33"; empty: as `core`
  double core_mhz;
  Flash flash{};
  std::uint32_t ram_bytes;
  std::uint32_t flash_bytes = 0;  ///< for code and scenes; 0: outside of the chip, modules differ
  double spi_mhz;                 ///< fastest clock with which the chip drives a display
  bool dma;                       ///< the bus sends while the core draws; without it the core waits
  std::uint32_t cores = 1;        ///< number of equal cores; one of them draws unless more are requested
  /// With a model of the core one number: the predicted cycles of K5M and CT (docs/measured/performance.md, "Boards")
  /// divided by the instructions that a Cortex-M3 counts for such plans. It is the mean of both; each differs from it
  /// by up to a quarter. For a board without a model it is an assumption.
  CyclesPerEstimate cycles_per_estimate;
};

/// RAM that arena and pixels cannot use: the renderer, other statics and the stack, rounded up from docs/memory.md.
inline constexpr std::uint32_t kReservedRam = 4096;

/// Returns the flash that a board keeps for code: half of it, at most 64 KB, an assumption. Minimal programs take 10 to
/// 35 KB (docs/measured/flash.md), and each effect some more.
constexpr std::uint32_t reserved_flash(const BoardModel& board) {
  constexpr std::uint32_t kMaxReserved = 64 * 1024;
  return board.flash_bytes / 2 < kMaxReserved ? board.flash_bytes / 2 : kMaxReserved;
}

/// Boards that have a model of the core come first.
std::span<const BoardModel> board_models();
std::span<const BoardModel> boards_with_core_model();
/// Returns null if there is no board of this name.
const BoardModel* find_board(std::string_view name);

}  // namespace zstrip::sim
