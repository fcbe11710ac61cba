// Counts the instructions of a frame on the host, with valgrind.
#pragma once

#include <cstdint>
#include <optional>

#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Instructions per frame, averaged over the frames of `bench_case`; empty where valgrind is not installed or cannot
/// run this program. This program runs twice under valgrind, drawing every frame once, then three times: the difference
/// is what two draws of every frame take, exactly, without start-up, staging and output.
Result<std::optional<std::uint64_t>> count_instructions(const BenchCase& bench_case);

}  // namespace zstrip::sim
