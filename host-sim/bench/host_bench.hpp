// Measures workloads on this machine.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/drawing.hpp"
#include "bench/measurement.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// One row for each case, in order. Time is the median over rounds that take turns among the cases, so that a slow
/// spell of the machine falls on all of them.
Result<std::vector<Measurement>> bench_on_host(const std::vector<BenchCase>& cases);

/// The frames of a case once; only drawing is timed, not the staging between.
Result<double> nanoseconds_per_frame(Drawing& drawing, const BenchCase& bench_case);

/// Stages every frame once and draws it `draws` times, measuring nothing: what runs under valgrind.
Result<Done> draw_only(const BenchCase& bench_case, std::uint32_t draws);

}  // namespace zstrip::sim
