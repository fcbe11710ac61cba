// A frame's memory by purpose, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "render/render_frame.hpp"

namespace zstrip::sim {

/// "ram_bytes" of a record; `arena` is the sum of what stands before it.
nlohmann::ordered_json ram_bytes(const FrameReport& report);

}  // namespace zstrip::sim
