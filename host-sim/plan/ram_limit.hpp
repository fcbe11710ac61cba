// The memory of a plan where none is asked for.
#pragma once

#include <cstdint>

#include "zstrip/budget.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {

/// Bytes for the arena and the strip's pixels if the user names no limit: small boards have this much.
inline constexpr std::uint32_t kUsualRam = 24 * 1024;

enum class RamLimit : std::uint8_t {
  given,  ///< a scene that needs more is refused
  whole,  ///< no limit, and one strip if no rows are given: two may be estimated to be faster
  usual,  ///< kUsualRam, or a board's memory; a scene that needs more gets as much as it needs
};

/// Returns the budget, with the bytes of the smallest plan if these are more and the limit allows it.
constexpr Budget with_enough_ram(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget,
                                 RamLimit limit) {
  if (limit == RamLimit::given) return budget;
  if (limit == RamLimit::whole) {
    Budget whole = budget;
    if (whole.strip_rows == 0) whole.strip_rows = view.height;
    return whole;
  }
  const Status status = plan(counts, view, effects, budget).status;
  Budget enough = budget;
  if (status.error == Error::arena_too_small) enough.bytes = status.needed;
  return enough;
}

}  // namespace zstrip::sim
