// A stage for a scene file (.toml).
#pragma once

#include <memory>
#include <string>

#include "render/stage.hpp"

namespace zstrip::sim {

/// The camera is the file's, or placed by the options (in the file's units), or else as close as the picture allows.
/// Without an animation all instances outside of the static layer rotate about the world's y axis.
Result<std::unique_ptr<Stage>> open_composed_stage(const std::string& path, const CameraOptions& options,
                                                   const View& view, std::uint32_t frames);

}  // namespace zstrip::sim
