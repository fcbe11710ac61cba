// Makes rows of pipelines with a visibility method and all effects that it supports; they can count and cull.
#pragma once

#include "zstrip/effects/exclusions.hpp"
#include "zstrip/frame/make_rows.hpp"
#include "zstrip/visibility.hpp"

namespace zstrip::detail {

template <Effects method>
constexpr Effects everything_with() {
  constexpr Effects kAll = kEverything | method::culling | method;
  return without(kAll, refused_by_methods(kAll));
}
template <Effects... methods>
constexpr auto rows_with() {
  return pipeline_rows<everything_with<methods>()..., everything_with<methods>() | effect::orthographic...>();
}

/// Returns pipelines for most scenes with a method, without statistics, as in firmware.
std::span<const PipelineRow> rows_of_measured_methods();

}  // namespace zstrip::detail
