// Declared, not there: what code without effects of fragments may know of them.
#pragma once

#include "zstrip/geometry/light.hpp"
#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::detail {

template <Effects effects>
struct FragmentPlanes;
template <class... Arguments>
void draw_fragment_triangle(const Arguments&...);
template <class... Arguments>
void fill_fragments(const Arguments&...);

}  // namespace zstrip::detail
