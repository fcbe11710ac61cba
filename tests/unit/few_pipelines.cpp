// In place of the pipelines that take longest to compile those that these tests draw with.
#include "zstrip/frame/make_rows.hpp"

namespace zstrip::detail {
namespace {

constexpr auto kRows = pipeline_rows<without(effect::all, effect::orthographic) | effect::depth_24>();

}  // namespace

std::span<const PipelineRow> rows_of_depth() { return kRows; }

}  // namespace zstrip::detail
