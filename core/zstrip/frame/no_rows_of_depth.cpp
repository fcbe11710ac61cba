// In place of the pipelines of other depth formats: none. What only these draw is refused.
#include "zstrip/frame/pipeline_rows.hpp"

namespace zstrip::detail {

std::span<const PipelineRow> rows_of_depth() { return {}; }

}  // namespace zstrip::detail
