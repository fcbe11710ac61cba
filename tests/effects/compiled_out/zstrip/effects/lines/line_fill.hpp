// Declared, not there: what code without lines may know of them.
#pragma once

#include "zstrip/effects/lines/lines.hpp"
#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/raster/fragment.hpp"

namespace zstrip::detail {

template <Effects effects>
struct LineShade;
template <Effects effects>
class LineFill;

}  // namespace zstrip::detail
