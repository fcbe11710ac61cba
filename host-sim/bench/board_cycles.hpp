// Estimates the cycles of a frame on a board from its work, kind by kind.
#pragma once

#include <optional>
#include <string_view>

#include "zstrip/plan.hpp"
#include "zstrip/plan/estimate.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Returns the cycles of drawing a streamed frame on the board of this name, flash included. Nothing for other plans,
/// and for boards whose frames were not counted kind by kind.
std::optional<double> estimated_cycles(std::string_view board, const SceneCounts& counts, Effects effects,
                                       const View& view, const Plan& plan, const Work& work);

}  // namespace zstrip::sim
