// Measures workloads on emulated boards.
#pragma once

#include <string>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// One row for each case, in order, by running firmware/boards/mps2's benchmark in QEMU. `firmware` is the folder of
/// the programs; empty: where the build puts them, seen from this program. A missing program or QEMU is a failure with
/// ExitStatus::environment, too little memory one with ExitStatus::budget.
Result<std::vector<Measurement>> bench_on_board(const std::vector<BenchCase>& cases, const std::string& firmware);

}  // namespace zstrip::sim
