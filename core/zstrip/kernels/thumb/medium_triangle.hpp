// The stages of medium triangles, in assembly for Cortex-M.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"

namespace zstrip::detail {

struct MediumScan;
struct SnappedVertex;

/// Does the same as set_up_medium_portable. For Thumb-2.
bool set_up_medium_thumb(MediumScan& scan, const SnappedVertex& v0, const SnappedVertex& v1, const SnappedVertex& v2);

/// Does the same as scan_medium_rows<true>.
void scan_medium_gouraud_thumb(MediumScan& scan, std::int32_t count);
/// Does the same as scan_medium_rows<false>.
void scan_medium_flat_thumb(MediumScan& scan, std::int32_t count);

}  // namespace zstrip::detail
