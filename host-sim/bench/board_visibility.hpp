// The cost of visibility methods on emulated boards: the table `boards` of `zstrip bench`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns one case for each workload, target and method; the method is in BenchCase::depth.
std::vector<BenchCase> board_visibility_cases();

/// Measures workloads of firmware/boards/mps2/bench_visibility.cpp at 320x240 in strips of 16 rows, on a Cortex-M0 and
/// a Cortex-M3. `firmware` as in board_program. Takes minutes.
Result<std::vector<Measurement>> measure_board_visibility(const std::string& firmware);

std::string board_visibility_text(std::span<const Measurement> rows);
std::string board_visibility_json(std::span<const Measurement> rows);

}  // namespace zstrip::sim
