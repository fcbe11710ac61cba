// Medium triangles in runs of small ones, and their stages in assembly for Cortex-M.
#pragma once

#include <cstdint>

#include "zstrip/kernels/processor.hpp"

namespace zstrip::detail {

struct MediumScan;
struct SnappedVertex;
struct ThumbSmallRun;

/// A triangle of a run, with the area and the colours of the run's scan. False: it is neither small nor medium.
bool draw_medium_of_run(const ThumbSmallRun& run, const SnappedVertex& v0, const SnappedVertex& v1,
                        const SnappedVertex& v2) asm("zstrip_draw_medium_of_run");

/// set_up_medium_portable. For Thumb-2.
bool set_up_medium_thumb(MediumScan& scan, const SnappedVertex& v0, const SnappedVertex& v1, const SnappedVertex& v2);

/// scan_medium_rows<true>.
void scan_medium_gouraud_thumb(MediumScan& scan, std::int32_t count);
/// scan_medium_rows<false>.
void scan_medium_flat_thumb(MediumScan& scan, std::int32_t count);

}  // namespace zstrip::detail
