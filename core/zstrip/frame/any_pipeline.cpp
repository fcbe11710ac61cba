// The table of all pipelines, for programs that learn the effects at run time.
#include <utility>

#include "zstrip/frame/pipeline.hpp"

namespace zstrip {
namespace {

/// Every program of this kind may bin: half as many pipelines.
constexpr Effects kAlways = effect::bins;

template <std::size_t... bits>
constexpr auto table_of(std::index_sequence<bits...>) {
  struct Table {
    Pipeline pipelines[sizeof...(bits)];
  };
  return Table{{{&detail::begin_frame<Effects{bits} | kAlways>, &detail::draw_strip<Effects{bits} | kAlways>,
                 &detail::draw_over<Effects{bits} | kAlways>}...}};
}

constexpr auto kTable = table_of(std::make_index_sequence<effect::all.bits + 1>{});

// 64 sets for each way to keep depth would be too many: these have one pipeline for each projection.
constexpr Effects kAllButProjection = without(effect::all, effect::orthographic) | effect::depth_state | kAlways;

template <Effects depth>
constexpr Pipeline full_pipeline(bool orthographic) {
  constexpr Effects kPerspective = kAllButProjection | depth;
  constexpr Effects kOrthographic = kPerspective | effect::orthographic;
  if constexpr (depth_effects_agree(kOrthographic)) {
    if (orthographic)
      return {&detail::begin_frame<kOrthographic>, &detail::draw_strip<kOrthographic>,
              &detail::draw_over<kOrthographic>};
  }
  return {&detail::begin_frame<kPerspective>, &detail::draw_strip<kPerspective>, &detail::draw_over<kPerspective>};
}

constexpr Pipeline kRefusing{
    [](Frame&, const Scene&, const Camera&, const View&, const Plan&, std::span<std::byte>) {
      return Status{.error = Error::depth_effects};
    },
    [](Frame&, std::uint16_t, std::span<std::byte>) { return Status{.error = Error::not_begun}; },
    [](Frame&, const Rect&, std::span<std::uint16_t>, std::span<std::uint16_t>) {
      return Status{.error = Error::not_begun};
    }};

}  // namespace

Pipeline pipeline_for(Effects effects) {
  if (effects.methods != 0) return pipeline_of_method(effects);
  if (!depth_effects_agree(effects)) return kRefusing;
  const bool orthographic = effects.has(effect::orthographic);
  if (effects.has(effect::depth_ranges)) return full_pipeline<effect::depth_ranges>(orthographic);
  switch (depth_format(effects)) {
    case DepthFormat::float16: return full_pipeline<effect::depth_float>(orthographic);
    case DepthFormat::w16: return full_pipeline<effect::depth_w16>(orthographic);
    case DepthFormat::z24: return full_pipeline<effect::depth_24>(orthographic);
    case DepthFormat::z32: return full_pipeline<effect::depth_32>(orthographic);
    case DepthFormat::z16: break;
  }
  if (effects.has(effect::depth_state)) return full_pipeline<Effects{}>(orthographic);
  return kTable.pipelines[effects.bits & effect::all.bits];
}

}  // namespace zstrip
