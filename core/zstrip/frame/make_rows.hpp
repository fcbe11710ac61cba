// Makes rows of the table of pipelines: here the stages of each are compiled.
#pragma once

#include <array>

#include "zstrip/frame/entry_points.hpp"
#include "zstrip/frame/pipeline_rows.hpp"

namespace zstrip::detail {

template <Effects effects>
constexpr PipelineRow pipeline_row() {
  return {effects, {&begin_frame<effects>, &draw_strip<effects>, &draw_over<effects>}};
}
template <Effects... effects>
constexpr auto pipeline_rows() {
  return std::array{pipeline_row<effects>()...};
}

/// All that a row can have beside what must be equal.
inline constexpr Effects kEverything =
    without(effect::of_scenes, effect::orthographic) | effect::statistics | effect::bins;

}  // namespace zstrip::detail
