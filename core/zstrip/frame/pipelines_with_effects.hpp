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

/// Refuses every frame, for effects that do not go together.
template <Error error>
constexpr Pipeline refusing() {
  return {[](Frame&, const Scene&, const Camera&, const View&, const Plan&, std::span<std::byte>) {
            return Status{.error = error};
          },
          [](Frame&, std::uint16_t, std::span<std::byte>) { return Status{.error = Error::not_begun}; },
          [](Frame&, const Rect&, std::span<std::uint16_t>, std::span<std::uint16_t>) {
            return Status{.error = Error::not_begun};
          }};
}

/// A pipeline that has all of `effects` (which agree) and draws the same as one that has them exactly; null if there
/// are unknown ones among them. Static storage.
const Pipeline* pipeline_with_effects(Effects effects);

}  // namespace zstrip::detail
