// The search for the pipeline of a set of effects.
#pragma once

#include "zstrip/frame/pipeline_rows.hpp"
#include "zstrip/status.hpp"

namespace zstrip::detail {

/// A row of the table of pipelines, or the reason why there is none.
struct RowFor {
  const PipelineRow* row;  ///< null: no pipeline draws the effects
  Error error;             ///< if there is no row: depth_effects or visibility
};

/// Finds the first row that draws the same pixels as a pipeline with exactly `effects`.
RowFor row_for(Effects effects);

}  // namespace zstrip::detail
