// The table of pipelines for programs that know the effects only at run time: the effects of each pipeline, and the
// search for the one that draws a set. There are too many sets for a pipeline each, so that rows are supersets.
#pragma once

#include <span>

#include "zstrip/frame/pipeline.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

struct PipelineRow {
  Effects effects;
  Pipeline pipeline;
};

/// Methods must be equal, except that a row may have culling in addition.
constexpr Effects own_method(Effects effects) { return without(Effects{0, effects.methods}, methods::kBesideOthers); }

/// True if a pipeline with `effects` draws the same pixels as one with exactly `wanted`: it has all of them, and depth
/// format, projection, accuracy of textures, and method are equal.
constexpr bool draws(Effects effects, Effects wanted) {
  constexpr Effects kEqual =
      effect::orthographic | effect::depth_formats | effect::depth_ranges | effect::perspective_runs;
  return effects.has(wanted) && (effects & kEqual) == (wanted & kEqual) && own_method(effects) == own_method(wanted) &&
         (effects.methods == 0) == (wanted.methods == 0);
}

// The rows, the fastest first. Lists are separate sources, to compile in parallel, and have static storage.
std::span<const PipelineRow> rows_of_triangles();  ///< scenes without other effects; each way to shade has its own row
std::span<const PipelineRow> rows_of_effects();    ///< any effects
std::span<const PipelineRow> rows_of_depth();      ///< any effects, with another format or mapping of depth
/// Two lists of the library zstrip::methods; empty until a program has linked and called it.
extern constinit std::span<const PipelineRow> further_rows[2];

}  // namespace zstrip::detail
