// Draws rows of medium textured triangles, in assembly for Cortex-M.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/pixels/textured_run_state.hpp"
#include "zstrip/pixels/textured_scan.hpp"

namespace zstrip::detail {

struct TexturedVertex;

/// Sets up the planes of 1/w, u/w and v/w, the bases and the right shift, from the triangle's vertices and
/// DepthFit::offset. set_up_medium_thumb must have set up the other planes. For Thumb-2.
void set_up_texture_thumb(TexturedScan& scan, const TexturedVertex* const* vertices, std::int64_t depth_offset);

/// Draws `count` > 0 rows with perspective and smooth light; moves the scan below them. `inverse` is kInverse.
void scan_textured_rows_thumb(TexturedScan& scan, const LitWordRunState& run, std::int32_t count,
                              const std::int32_t* inverse);

}  // namespace zstrip::detail
