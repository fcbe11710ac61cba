// A choice of plans as a table with a curve, and as JSON.
#pragma once

#include <string>

#include "plan/alternatives.hpp"

namespace zstrip::sim {

/// For a person.
std::string plan_table(const std::string& scene, const PlanRequest& request, const PlanChoice& choice);

/// One JSON object with a line end; keys are documented in README.md.
std::string plan_json(const std::string& scene, const PlanRequest& request, const PlanChoice& choice);

}  // namespace zstrip::sim
