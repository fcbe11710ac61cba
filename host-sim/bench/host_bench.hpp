// Measures workloads on this machine.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/drawing.hpp"
#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns one row for each case, in order. Time is the median over rounds that alternate between the cases, so that a
/// slow period of the machine affects all of them.
Result<std::vector<Measurement>> bench_on_host(const std::vector<BenchCase>& cases);

/// Draws the frames of a case once; only drawing is timed, without the staging between.
Result<double> nanoseconds_per_frame(Drawing& drawing, const BenchCase& bench_case);

/// Stages every frame once and draws it `draws` times without measurements; this runs under valgrind.
Result<Done> draw_only(const BenchCase& bench_case, std::uint32_t draws);

}  // namespace zstrip::sim
