// Finds the pipeline for a set of effects, for programs that know it only at run time.
#include "zstrip/effects/exclusions.hpp"
#include "zstrip/frame/row_for.hpp"

namespace zstrip {
namespace {

/// Refuses every frame, for effects that exclude each other.
template <Error error>
constexpr Pipeline refusing() {
  return {[](detail::FrameState&, const Scene&, const Camera&, const View&, const Plan&, std::span<std::byte>) {
            return Status{.error = error};
          },
          [](detail::FrameState&, std::uint16_t, std::span<std::byte>) { return Status{.error = Error::not_begun}; },
          [](detail::FrameState&, const Rect&, std::span<std::uint16_t>, std::span<std::uint16_t>) {
            return Status{.error = Error::not_begun};
          }};
}

}  // namespace

constinit std::span<const detail::PipelineRow> detail::further_rows[2];

detail::RowFor detail::row_for(Effects effects) {
  effects = without(effects, effect::shades | effect::unclipped);  // the rows support all shades, and clip
  const bool has_method = effects.methods != 0;
  if (has_method && (!methods_agree(effects) || effects.any(effect::depth_formats | effect::depth_ranges))) {
    return {nullptr, Error::visibility};
  }
  if (!effects_agree(effects)) return {nullptr, Error::depth_effects};
  // Without perspective, or without textures, these effects change no pixel.
  if (effects.has(effect::orthographic) || !effects.has(effect::textures)) {
    effects = without(effects, effect::perspective_runs);
  }
  // A program may define the later ones itself, so they are called only where no earlier row draws the effects.
  for (const auto rows : {&rows_of_triangles, &rows_of_effects, &rows_of_depth, +[] { return further_rows[0]; },
                          +[] { return further_rows[1]; }}) {
    for (const PipelineRow& row : rows()) {
      if (draws(row.effects, effects)) return {&row, Error::none};
    }
  }
  return {nullptr, has_method ? Error::visibility : Error::depth_effects};
}

Pipeline pipeline_for(Effects effects) {
  const detail::RowFor found = detail::row_for(effects);
  if (found.row != nullptr) return found.row->pipeline;
  return found.error == Error::visibility ? refusing<Error::visibility>() : refusing<Error::depth_effects>();
}

}  // namespace zstrip
