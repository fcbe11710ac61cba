// The instructions that a program for a board executed, as plugin/counting_plugin.cpp counts them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

struct ExecutedInstruction {
  std::uint32_t address = 0;
  std::uint32_t bytes = 0;  ///< 2 or 4
  std::string text;         ///< disassembled: mnemonic and operands, lower case
};

/// Consecutive instructions; only the last one can branch.
struct ExecutedBlock {
  std::uint32_t first = 0;  ///< index into ExecutionProfile::instructions
  std::uint32_t count = 0;
};

struct BlockExecutions {
  std::uint32_t block = 0;  ///< index into ExecutionProfile::blocks
  std::uint64_t executions = 0;
  std::uint64_t taken = 0;  ///< number of times that its end branched to another address than the next instruction
};

/// The region of begin_frame, or of one strip.
struct ExecutedRegion {
  std::vector<BlockExecutions> blocks;
  std::uint64_t jump_misses = 0;        ///< lines of code that were not in the flash cache, after a jump
  std::uint64_t sequential_misses = 0;  ///< lines of code that were not in the flash cache, after the line before them
  std::uint64_t data_misses = 0;        ///< reads of constants whose line was not in the cache
};

struct ExecutionProfile {
  std::vector<ExecutedInstruction> instructions;  ///< an address may occur twice, in different blocks
  std::vector<ExecutedBlock> blocks;
  std::vector<ExecutedRegion> regions;  ///< for each frame begin_frame, then its strips in order
};

std::uint64_t instruction_count(const ExecutionProfile& profile, const ExecutedRegion& region);

/// The cache between flash and core; see flash_cache.hpp. Without lines every fetch or read goes to the flash.
struct FlashCacheShape {
  std::uint32_t line_bytes = 8;
  std::uint32_t code_lines = 0, code_ways = 1;
  std::uint32_t data_lines = 0, data_ways = 1;
  bool shared = false;  ///< data accesses use the cache of the code
};

struct ProfiledCase {
  Measurement measurement;
  ExecutionProfile profile;
  std::filesystem::path program;  ///< the program that was run
};

/// Runs the case as bench_on_board does, with the plugin. Fails with ExitStatus::environment if QEMU, the program or
/// the plugin is missing, or QEMU cannot load the plugin.
Result<ProfiledCase> profile_on_board(const BenchCase& bench_case, const FlashCacheShape& cache,
                                      const std::string& firmware);

/// Reads the plugin's output; fails with ExitStatus::internal if it has another format.
Result<ExecutionProfile> read_profile(const std::filesystem::path& file);

}  // namespace zstrip::sim
