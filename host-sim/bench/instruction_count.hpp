// Counts the instructions of drawing on the host, with valgrind.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Instructions of one draw of everything that a command draws; empty where valgrind is not installed or cannot run the
/// command. It runs twice under valgrind, with --draw-each 1 and 3 behind its other words: the difference is what two
/// draws take, exactly, without start-up, staging and output. `environment`: words as "NAME=VALUE". `what` is for the
/// message of a failure. The C library sets memory with vector stores, because valgrind counts its other way, an x86
/// instruction that repeats itself, as an instruction for each byte.
Result<std::optional<std::uint64_t>> count_draws(const std::vector<std::string>& command,
                                                 const std::vector<std::string>& environment, const std::string& what);

/// The same of `zstrip bench` with these options.
Result<std::optional<std::uint64_t>> count_draw(const std::vector<std::string>& options, const std::string& what);

/// Instructions per frame, averaged over the frames of `bench_case`.
Result<std::optional<std::uint64_t>> count_instructions(const BenchCase& bench_case);

}  // namespace zstrip::sim
