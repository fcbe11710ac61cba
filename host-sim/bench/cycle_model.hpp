// Cycles of executed instructions, from the timings that Arm publishes and the wait states of a flash. A model, with
// bounds: what the manuals leave open, or what depends on neighbours that are not looked at, makes a range.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "bench/execution_profile.hpp"
#include "bench/instruction_class.hpp"

namespace zstrip::sim {

struct Cycles {
  double low = 0, high = 0;
  Cycles& operator+=(const Cycles& other) {
    low += other.low;
    high += other.high;
    return *this;
  }
};
constexpr Cycles operator*(double times, const Cycles& cycles) { return {times * cycles.low, times * cycles.high}; }

/// Of one core, in cycles without wait states.
struct CoreTimings {
  std::string_view core;                                                        ///< "m0", "m0+", "m3", "m4" or "m33"
  std::string_view name;                                                        ///< as Arm spells it
  std::string_view source;                                                      ///< the manual, and the table of it
  Cycles multiply, accumulate{}, long_multiply{}, long_accumulate{}, divide{};  ///< zeros: it has none
  Cycles load, store;                                                           ///< single ones
  Cycles next_transfer;     ///< a single load or store right behind another one: where both are pipelined
  Cycles multiple_base;     ///< LDM and its kin take this and 1 a register
  Cycles not_taken, taken;  ///< B with a condition
  Cycles call, branch_register;
  Cycles pc_load_extra;  ///< what loading the program counter takes beside the load
  Cycles complex{1, 1};  ///< ClassifiedInstruction::complex
};

/// Null if none is known.
const CoreTimings* find_core(std::string_view core);

struct Flash {
  std::string_view description;
  std::uint32_t wait_states = 0;  ///< cycles that a line which is not in the cache takes beyond the first
  FlashCacheShape cache;
  bool prefetch = false;  ///< the line behind the current one is read while that executes
};

/// How many instructions of each class a region executed, and of its branches how many were taken.
struct InstructionMix {
  std::array<std::uint64_t, kInstructionClassNames.size()> count{};
  std::uint64_t taken = 0;
  InstructionMix& operator+=(const InstructionMix& other);
};
InstructionMix mix_of(const ExecutionProfile& profile, const ExecutedRegion& region);

/// Of the instructions alone, and of what the flash makes the core wait.
Cycles core_cycles(const ExecutionProfile& profile, const ExecutedRegion& region, const CoreTimings& core);
Cycles flash_cycles(const ExecutedRegion& region, const Flash& flash);

}  // namespace zstrip::sim
