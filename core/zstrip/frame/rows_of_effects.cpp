// Pipelines of scenes with any effects.
#include "zstrip/frame/make_rows.hpp"

namespace zstrip::detail {
namespace {

constexpr auto kRowsOfEffects = pipeline_rows<kEverything, kEverything | effect::orthographic>();

}  // namespace

std::span<const PipelineRow> rows_of_effects() { return kRowsOfEffects; }

}  // namespace zstrip::detail
