// The set-up and the scan of small triangles, in assembly for Cortex-M.
#pragma once

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

struct SmallScan;

/// Sets up the planes of edges, depth and colours from `scan.area`, `anchor_x`, `anchor_y`, `colours` and the vertices,
/// as set_up_small_portable<true> does.
void set_up_small_thumb(SmallScan& scan, const SnappedVertex& v0, const SnappedVertex& v1,
                        const SnappedVertex& v2) asm("zstrip_set_up_small_thumb");

/// Does the same as scan_small_portable<true, false> with the depth test of z16. Changes the scan's starts and rows.
void scan_small_thumb(SmallScan& scan) asm("zstrip_scan_small_thumb");
/// Scans a triangle of one colour, as scan_small_portable<false, false> does.
void scan_small_flat_thumb(SmallScan& scan);

}  // namespace zstrip::detail
