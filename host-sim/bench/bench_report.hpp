// Measurements as a table for people and as JSON for programs.
#pragma once

#include <span>
#include <string>

#include "bench/measurement.hpp"

namespace zstrip::sim {

/// One line a row, with headings, a line end after each; the figures of other renderers beside those they compare with.
std::string bench_table(std::span<const Measurement> rows);

/// An array with one object a row; the keys are documented in bench/README.md. Ends with a line end.
std::string bench_json(std::span<const Measurement> rows);

}  // namespace zstrip::sim
