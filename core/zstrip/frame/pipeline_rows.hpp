// The table of pipelines for programs that learn the effects at run time: which effects each has, and which one draws a
// set. There is no end of sets, so that rows are supersets.
#pragma once

#include <span>

#include "zstrip/frame/pipeline.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

struct PipelineRow {
  Effects effects;
  Pipeline pipeline;
};

/// Methods are equal but for culling, which a row may have beside one.
constexpr Effects own_method(Effects effects) { return without(Effects{0, effects.methods}, methods::kBesideOthers); }

/// True if a pipeline of these effects draws as one with exactly `wanted` does: it has all of them, and the way to
/// keep depth, the projection, the accuracy of textures, and the method are the same.
constexpr bool draws(Effects effects, Effects wanted) {
  constexpr Effects kEqual =
      effect::orthographic | effect::depth_formats | effect::depth_ranges | effect::perspective_runs;
  return effects.has(wanted) && (effects & kEqual) == (wanted & kEqual) && own_method(effects) == own_method(wanted) &&
         (effects.methods == 0) == (wanted.methods == 0);
}

// The rows, those that draw fastest first. Each list is a source of its own, so that they compile side by side. Static
// storage.
std::span<const PipelineRow> rows_of_triangles();  ///< scenes without further effects, each way to shade for itself
std::span<const PipelineRow> rows_of_effects();    ///< any effects
std::span<const PipelineRow> rows_of_depth();      ///< any effects with another format or mapping of depth
/// Two lists of a library that the program links and has called: zstrip::methods. Else empty.
extern constinit std::span<const PipelineRow> further_rows[2];

}  // namespace zstrip::detail
