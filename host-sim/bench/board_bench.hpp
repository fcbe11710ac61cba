// Measures workloads on emulated boards.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns one row for each case, in order, from firmware/boards/mps2's benchmark in QEMU. `firmware` is the folder of
/// the programs; empty: the build's folder, relative to this program. A missing program or QEMU is a failure with
/// ExitStatus::environment, too little memory a failure with ExitStatus::budget.
Result<std::vector<Measurement>> bench_on_board(const std::vector<BenchCase>& cases, const std::string& firmware);

/// Returns the name of the program that draws a case, which is the name of its target in CMake.
std::string board_program_of(const BenchCase& bench_case);
/// Returns the words that this program reads, as options of QEMU. A program that plays a file calls it "scene".
std::string board_words(const BenchCase& bench_case);
/// Returns the file of this program, in the folder `firmware` as above.
Result<std::filesystem::path> board_program(const BenchCase& bench_case, const std::string& firmware);
/// Measures one case, with more options for QEMU. Failures as above.
Result<Measurement> bench_on_board(const BenchCase& bench_case, const std::filesystem::path& program,
                                   const std::vector<std::string>& emulator_options);

}  // namespace zstrip::sim
