// Draws runs of small triangles with interpolated colours: set-up of four triangles at a time in vectors of Helium,
// then the rows of each, four pixels at a time.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb/small_run.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Does the same as draw_small_run_thumb. Of `run.scan` it changes only the area and the colours.
std::uint32_t draw_small_run_mve(ThumbSmallRun& run, const Triangle* triangles, std::uint32_t count);

}  // namespace zstrip::detail
