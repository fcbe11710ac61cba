// Prints a choice of plans as a table with a curve, or as JSON.
#pragma once

#include <string>

#include "plan/alternatives.hpp"

namespace zstrip::sim {

/// Returns the table of a choice of plans.
std::string plan_table(const std::string& scene, const PlanRequest& request, const PlanChoice& choice);

/// Returns one JSON object with a line end; host-sim/README.md documents its keys.
std::string plan_json(const std::string& scene, const PlanRequest& request, const PlanChoice& choice);

}  // namespace zstrip::sim
