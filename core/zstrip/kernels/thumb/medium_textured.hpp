// Rows of medium textured triangles in assembly for Cortex-M.
#pragma once

#include <cstdint>

#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/textured_run_state.hpp"
#include "zstrip/kernels/textured_scan.hpp"

namespace zstrip::detail {

/// `count` > 0 rows of a triangle with perspective in smooth light; moves the scan below them. `inverse` is kInverse.
/// For Thumb-2.
void scan_textured_rows_thumb(TexturedScan& scan, const LitRunState<TexturedRunState<std::uint32_t>>& run,
                              std::int32_t count, const std::int32_t* inverse);

}  // namespace zstrip::detail
