// Names of options and scene files for the number of pixels between exact texture coordinates of a row.
#pragma once

#include <string_view>
#include <utility>

#include "zstrip/effects.hpp"

namespace zstrip::sim {

/// Pixels from one pair of exact texture coordinates to the next, linear between them. `affine`: only at the
/// triangle's corners. No effect: 16.
inline constexpr std::pair<std::string_view, Effects> kPerspectiveRuns[] = {{"affine", effect::perspective_affine},
                                                                            {"16", Effects{}},
                                                                            {"8", effect::perspective_8},
                                                                            {"1", effect::perspective_1}};

}  // namespace zstrip::sim
