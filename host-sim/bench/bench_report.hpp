// Measurements as a table for display and as JSON for programs.
#pragma once

#include <span>
#include <string>

#include "bench/measurement.hpp"

namespace zstrip::sim {

/// Returns one line for each row, with headings and line ends; figures of other renderers follow those they compare
/// with.
std::string bench_table(std::span<const Measurement> rows);

/// Returns an array with one object for each row; bench/README.md documents the keys. Ends with a line end.
std::string bench_json(std::span<const Measurement> rows);

}  // namespace zstrip::sim
