// Counts the instructions of drawing on the host, with valgrind.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns the instructions of one draw of everything that a command draws; nothing if valgrind is not installed or
/// cannot run the command. Runs the command twice under valgrind, with --draw-each 1 and 3 added: the difference is
/// exactly the work of two draws, without start-up, staging and output. `environment`: words as "NAME=VALUE". `what` is
/// for the message of a failure. The C library sets memory with vector stores here, because valgrind counts the
/// alternative, a repeated x86 instruction, as one instruction for each byte.
Result<std::optional<std::uint64_t>> count_draws(const std::vector<std::string>& command,
                                                 const std::vector<std::string>& environment, const std::string& what);

/// Counts the draw of `zstrip bench` with these options.
Result<std::optional<std::uint64_t>> count_draw(const std::vector<std::string>& options, const std::string& what);

/// Returns the instructions per frame, averaged over the frames of `bench_case`.
Result<std::optional<std::uint64_t>> count_instructions(const BenchCase& bench_case);

}  // namespace zstrip::sim
