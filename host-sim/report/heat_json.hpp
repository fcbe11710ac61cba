// Writes the differences of a frame from the truth as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "accuracy/heat_map.hpp"

namespace zstrip::sim {

/// "accuracy" of a record.
nlohmann::ordered_json heat_json(const HeatFigures& figures);

}  // namespace zstrip::sim
