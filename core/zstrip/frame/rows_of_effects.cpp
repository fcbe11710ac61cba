// Pipelines of scenes with any effects.
#include "zstrip/frame/pipeline_rows.hpp"

namespace zstrip::detail {
namespace {

constexpr auto kRows = pipeline_rows<kEverything, kEverything | effect::orthographic>();

}  // namespace

std::span<const PipelineRow> rows_of_effects() { return kRows; }

}  // namespace zstrip::detail
