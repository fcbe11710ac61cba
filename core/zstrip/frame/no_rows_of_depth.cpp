// An empty table in place of the pipelines of other depth formats: sets that need these are refused.
#include "zstrip/frame/pipeline_rows.hpp"

namespace zstrip::detail {

std::span<const PipelineRow> rows_of_depth() { return {}; }

}  // namespace zstrip::detail
