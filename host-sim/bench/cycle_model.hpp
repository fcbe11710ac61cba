// Cycles of executed instructions, from the timings that Arm publishes and the wait states of a flash. The model gives
// a range where the manuals are not definite, or where a timing depends on neighbours that are not examined.
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

/// The timings of one core, in cycles without wait states.
struct CoreTimings {
  std::string_view core;                                                        ///< "m0", "m0+", "m3", "m4" or "m33"
  std::string_view name;                                                        ///< as Arm spells it
  std::string_view source;                                                      ///< the manual, and the table of it
  Cycles multiply, accumulate{}, long_multiply{}, long_accumulate{}, divide{};  ///< zeros: the core has no such
                                                                                ///< instruction
  Cycles load, store;                                                           ///< single ones
  Cycles next_transfer;     ///< a single load or store directly after another one, if both are pipelined
  Cycles multiple_base;     ///< LDM and similar instructions take this and 1 for each register
  Cycles not_taken, taken;  ///< B with a condition
  Cycles call, branch_register;
  Cycles pc_load_extra;  ///< cycles to load the program counter, in addition to the load
  Cycles complex{1, 1};  ///< ClassifiedInstruction::complex
};

/// Returns null if the core is not known.
const CoreTimings* find_core(std::string_view core);

struct Flash {
  std::string_view description;
  std::uint32_t wait_states = 0;  ///< additional cycles to read a line that is not in the cache
  FlashCacheShape cache;
  bool prefetch = false;  ///< the line after the current one is read while the current one executes
};

/// The number of instructions of each class that a region executed, and the number of branches that were taken.
struct InstructionMix {
  std::array<std::uint64_t, kInstructionClassNames.size()> count{};
  std::uint64_t taken = 0;
  InstructionMix& operator+=(const InstructionMix& other);
};
InstructionMix mix_of(const ExecutionProfile& profile, const ExecutedRegion& region);

/// Return the cycles of the instructions alone, and the cycles in which the core waits for the flash.
Cycles core_cycles(const ExecutionProfile& profile, const ExecutedRegion& region, const CoreTimings& core);
Cycles flash_cycles(const ExecutedRegion& region, const Flash& flash);

}  // namespace zstrip::sim
