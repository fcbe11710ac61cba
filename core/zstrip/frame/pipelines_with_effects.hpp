// The pipelines of programs that learn the effects at run time, for sets with effects that few scenes call for:
// supersets of them, because there is no end of sets.
#pragma once

#include "zstrip/frame/pipeline.hpp"

namespace zstrip::detail {

/// Effects that the table of any_pipeline.cpp does not know.
inline constexpr Effects kBeyondTable = without({~std::uint64_t{0}}, effect::all | effect::bins);

template <Effects effects>
constexpr Pipeline pipeline() {
  return {&begin_frame<effects>, &draw_strip<effects>, &draw_over<effects>};
}

/// A pipeline that has all of `effects` (which agree) and draws the same as one that has them exactly; null if there
/// are unknown ones among them. Static storage.
const Pipeline* pipeline_with_effects(Effects effects);

}  // namespace zstrip::detail
