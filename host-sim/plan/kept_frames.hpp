// Measures the memory of the scene's frames as static layers: each frame is drawn and kept as if it were the
// background.
#pragma once

#include <cstdint>

#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/budget.hpp"
#include "zstrip/plan/depth_choice.hpp"

namespace zstrip::sim {

/// Bytes of a pool, including its index.
struct KeptBytes {
  std::uint32_t worst = 0;    ///< enough for any picture of this size
  std::uint32_t largest = 0;  ///< of the frames
  std::uint32_t average = 0;
};

struct KeptFrames {
  std::uint32_t frames = 0;
  DepthFormat format = DepthFormat::z16;  ///< of the kept depth
  Fixed nearest = 0, farthest = 0;        ///< distances of the surfaces of all frames, 16.16; 0 if none is visible
  DepthRange codes{};                     ///< the range of the codes
  bool possible = true;                   ///< false: shadows overwrite the z-buffer, and the members below are not set
  KeptBytes depth, colour;
  std::uint32_t dirty = 0;

  /// Returns pools for the largest frame.
  LayerBytes layer() const { return {depth.largest, colour.largest, dirty}; }
};

/// Draws `frames` (> 0) frames of the motion in RGB565 with a format of 16-bit cells. With `fixed_range` the depth
/// range is the camera's, as layers need it; otherwise it is fitted to each frame.
Result<KeptFrames> keep_frames(Stage& stage, const View& view, DepthFormat format, std::uint32_t frames,
                               bool fixed_range);

}  // namespace zstrip::sim
