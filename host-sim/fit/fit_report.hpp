// The choices of `zstrip fit` as a table, as JSON and as a page.
#pragma once

#include <cstddef>
#include <string>

#include "fit/choices.hpp"

namespace zstrip::sim {

/// `chosen`: an index of FitSearch::choices, of which there is at least one.
std::string fit_table(const FitSearch& found, const BoardModel& board, std::size_t chosen);
/// One JSON object with a line end; keys are documented in host-sim/README.md.
std::string fit_json(const FitSearch& found, const BoardModel& board, std::size_t chosen);
/// A page with the pictures inside.
Result<std::string> fit_page(const FitSearch& found, const BoardModel& board, std::size_t chosen);

}  // namespace zstrip::sim
