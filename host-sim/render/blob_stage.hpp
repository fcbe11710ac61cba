// A stage for a baked scene (.zsc): opened in place, rotated about the y axis.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "render/stage.hpp"

namespace zstrip::sim {

/// The camera is the blob's own, unless the options place another one (in the scene's units) or change its projection.
/// In a picture narrower than the one that the blob was baked for, the camera shows the same width.
/// `clip`: the name of the blob's clip that is shown; empty: the first one.
Result<std::unique_ptr<Stage>> open_blob_stage(const std::string& path, const CameraOptions& options, const View& view,
                                               std::uint32_t frames, const std::optional<std::string>& clip = {});

/// The picture that a blob was baked for.
struct BakedPicture {
  View view;
  Effects effects;  ///< one of kPictureEffects
};
Result<BakedPicture> picture_of_blob(const std::string& path);

}  // namespace zstrip::sim
