// Makes rows of the table of pipelines. The stages of each pipeline are compiled here.
#pragma once

#include <array>

#include "zstrip/frame/begin_frame.hpp"
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

/// All effects that a row can have in addition to those that must be equal.
inline constexpr Effects kEverything =
    without(effect::of_scenes, effect::orthographic) | effect::statistics | effect::bins;

}  // namespace zstrip::detail
