// Names of the work that effects add, for JSON; in the order of WorkKind.
#pragma once

#include <iterator>
#include <string_view>

#include "zstrip/base/statistics.hpp"

namespace zstrip::sim {

inline constexpr std::string_view kWorkNames[] = {"textured_triangles",
                                                  "textured_fragments",
                                                  "lit_textured_triangles",
                                                  "lit_textured_fragments",
                                                  "staged_triangles",
                                                  "staged_fragments",
                                                  "staged_textures",
                                                  "spans",
                                                  "runs",
                                                  "runs_of_levels",
                                                  "nearest_texels",
                                                  "bilinear_texels",
                                                  "texel_alphas",
                                                  "lit_texels",
                                                  "lit_fragments",
                                                  "masked",
                                                  "fogged",
                                                  "blended",
                                                  "dithered",
                                                  "lit_vertices",
                                                  "lights_of_vertices",
                                                  "shining_vertices",
                                                  "mirroring_vertices",
                                                  "clips",
                                                  "cells_of_shadow_map",
                                                  "shadow_samples",
                                                  "hull_vertices",
                                                  "meshlets_again",
                                                  "vertices_again",
                                                  "triangles_again",
                                                  "fragments_again",
                                                  "fragments_of_quadrics",
                                                  "fragments_of_lines",
                                                  "searched_edges",
                                                  "surveyed_edges",
                                                  "projected_edges",
                                                  "blended_edges",
                                                  "pixels_of_edges"};
static_assert(std::size(kWorkNames) == kWorkKinds);

}  // namespace zstrip::sim
