// The tables of timings and their sums.
#include "bench/cycle_model.hpp"

#include <algorithm>

namespace zstrip::sim {
namespace {

// Arm's manuals of these cores have a table "instruction set summary" with a column of cycles. N: registers moved; P:
// cycles to refill the pipeline, "1 to 3, depending on alignment and width of the target" on M3 and M4. Multiplication
// in one cycle is an option of M0 and M0+ that all chips of boards.cpp have.
constexpr std::array kCores{
    CoreTimings{.core = "m0",
                .name = "Cortex-M0",
                .source = "Cortex-M0 Technical Reference Manual, instruction set summary",
                .multiply = {1, 1},
                .load = {2, 2},
                .store = {2, 2},
                .next_transfer = {2, 2},
                .multiple_base = {1, 1},
                .not_taken = {1, 1},
                .taken = {3, 3},
                .call = {4, 4},
                .branch_register = {3, 3},
                .pc_load_extra = {3, 3}},
    CoreTimings{.core = "m0+",
                .name = "Cortex-M0+",
                .source = "Cortex-M0+ Technical Reference Manual, instruction set summary",
                .multiply = {1, 1},
                .load = {2, 2},
                .store = {2, 2},
                .next_transfer = {2, 2},
                .multiple_base = {1, 1},
                .not_taken = {1, 1},
                .taken = {2, 2},
                .call = {3, 3},
                .branch_register = {2, 2},
                .pc_load_extra = {2, 2}},
    CoreTimings{.core = "m3",
                .name = "Cortex-M3",
                .source = "Cortex-M3 Technical Reference Manual, instruction set summary and load/store timings",
                .multiply = {1, 1},
                .accumulate = {2, 2},
                .long_multiply = {3, 5},
                .long_accumulate = {4, 7},
                .divide = {2, 12},
                .load = {2, 2},
                .store = {1, 2},
                .next_transfer = {1, 2},
                .multiple_base = {1, 1},
                .not_taken = {1, 1},
                .taken = {2, 4},
                .call = {2, 4},
                .branch_register = {2, 4},
                .pc_load_extra = {1, 3}},
    CoreTimings{.core = "m4",
                .name = "Cortex-M4",
                .source = "Cortex-M4 Technical Reference Manual, instruction set summary and load/store timings",
                .multiply = {1, 1},
                .accumulate = {1, 2},
                .long_multiply = {1, 1},
                .long_accumulate = {1, 1},
                .divide = {2, 12},
                .load = {2, 2},
                .store = {1, 2},
                .next_transfer = {1, 2},
                .multiple_base = {1, 1},
                .not_taken = {1, 1},
                .taken = {2, 4},
                .call = {2, 4},
                .branch_register = {2, 4},
                .pc_load_extra = {1, 3}},
    // Measured by the maker of a chip, not Arm. An instruction that uses a result which comes late waits a cycle;
    // branches are folded into the instruction before them or not, and their target is a whole word or not.
    CoreTimings{.core = "m33",
                .name = "Cortex-M33",
                .source = "RP2350 data sheet, execution timing of its Cortex-M33",
                .multiply = {1, 2},
                .accumulate = {1, 2},
                .long_multiply = {1, 2},
                .long_accumulate = {1, 2},
                .divide = {2, 12},
                .load = {1, 2},
                .store = {1, 1},
                .next_transfer = {1, 2},
                .multiple_base = {0, 1},
                .not_taken = {0, 1},
                .taken = {1, 3},
                .call = {2, 3},
                .branch_register = {1, 3},
                .pc_load_extra = {3, 4},
                .complex = {1, 2}},
};

constexpr Cycles kOne{1, 1};

bool single_transfer(const ClassifiedInstruction& instruction) {
  return (instruction.kind == InstructionClass::load || instruction.kind == InstructionClass::store) &&
         !instruction.loads_pc;
}

/// Returns the cycles of one execution, without the extra cycles of a taken branch.
Cycles cycles_of(const ClassifiedInstruction& instruction, bool behind_transfer, const CoreTimings& core) {
  using enum InstructionClass;
  switch (instruction.kind) {
    case other: return instruction.complex ? core.complex : kOne;
    case multiply: return core.multiply;
    case accumulate: return core.accumulate;
    case long_multiply: return core.long_multiply;
    case long_accumulate: return core.long_accumulate;
    case divide: return core.divide;
    case load: return behind_transfer ? core.next_transfer : core.load;
    case store: return behind_transfer ? core.next_transfer : core.store;
    case load_multiple:
    case store_multiple: {
      const auto words = static_cast<double>(instruction.words);
      return {core.multiple_base.low + words, core.multiple_base.high + words};
    }
    case branch: return core.not_taken;
    case call: return core.call;
    case branch_register: return core.branch_register;
  }
  return kOne;
}

/// Returns the extra cycles of one taken end of a block.
Cycles taken_extra(const ClassifiedInstruction& last, const CoreTimings& core) {
  if (last.loads_pc) return core.pc_load_extra;
  if (last.kind != InstructionClass::branch) return {};  // calls are always taken, and exceptions do not happen
  return {core.taken.low - core.not_taken.low, core.taken.high - core.not_taken.high};
}

}  // namespace

const CoreTimings* find_core(std::string_view core) {
  const auto* found = std::ranges::find(kCores, core, &CoreTimings::core);
  return found == kCores.end() ? nullptr : found;
}

InstructionMix& InstructionMix::operator+=(const InstructionMix& other) {
  for (std::size_t i = 0; i < count.size(); ++i) count[i] += other.count[i];
  taken += other.taken;
  return *this;
}

InstructionMix mix_of(const ExecutionProfile& profile, const ExecutedRegion& region) {
  InstructionMix mix;
  for (const BlockExecutions& executed : region.blocks) {
    const ExecutedBlock& block = profile.blocks[executed.block];
    for (std::uint32_t i = 0; i < block.count; ++i) {
      const auto kind = classify(profile.instructions[block.first + i].text).kind;
      mix.count[static_cast<std::size_t>(kind)] += executed.executions;
      if (i + 1 == block.count && kind == InstructionClass::branch) mix.taken += executed.taken;
    }
  }
  return mix;
}

Cycles core_cycles(const ExecutionProfile& profile, const ExecutedRegion& region, const CoreTimings& core) {
  Cycles sum;
  for (const BlockExecutions& executed : region.blocks) {
    const ExecutedBlock& block = profile.blocks[executed.block];
    Cycles once;
    ClassifiedInstruction instruction;
    bool behind_transfer = false;
    for (std::uint32_t i = 0; i < block.count; ++i) {
      instruction = classify(profile.instructions[block.first + i].text);
      once += cycles_of(instruction, behind_transfer, core);
      behind_transfer = single_transfer(instruction);
    }
    sum += static_cast<double>(executed.executions) * once;
    sum += static_cast<double>(executed.taken) * taken_extra(instruction, core);
  }
  return sum;
}

Cycles flash_cycles(const ExecutedRegion& region, const Flash& flash) {
  const double wait = flash.wait_states;
  // A line takes at least one cycle for each 4 bytes; prefetching hides the same time of reading the next line.
  const double left = std::max(0.0, wait + 1 - flash.cache.line_bytes / 4.0);
  const Cycles sequential = flash.prefetch ? Cycles{0, left} : Cycles{wait, wait};
  Cycles sum = static_cast<double>(region.jump_misses + region.data_misses) * Cycles{wait, wait};
  sum += static_cast<double>(region.sequential_misses) * sequential;
  return sum;
}

}  // namespace zstrip::sim
