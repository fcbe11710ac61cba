// The pipelines with a visibility method, of programs that learn the method at run time.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "zstrip/frame/pipelines_with_effects.hpp"
#include "zstrip/frame/visibility_stages.hpp"

namespace zstrip::detail {

/// Two of each method and projection, because what counts slows all of them alike: one for triangles, one that has all
/// that the method does not refuse.
inline constexpr Effects kOfTriangles = without(effect::all, effect::orthographic) | effect::bins | method::culling;

/// All methods without culling; none at all is culling alone.
inline constexpr std::array kMethodSets{Effects{},
                                        method::painter,
                                        method::painter | method::in_order,
                                        method::painter | method::bsp,
                                        method::front_to_back,
                                        method::hierarchical_z,
                                        method::front_to_back | method::hierarchical_z,
                                        method::midpoint,
                                        method::midpoint_safe};

/// What make.template operator()<set>() gives for the set that is `own`; refuses every frame if there is none.
template <class Make>
Pipeline pipeline_of_set(Effects own, const Make& make) {
  Pipeline pipeline = refusing<Error::visibility>();
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    static_cast<void>(
        ((own == kMethodSets[i] && (pipeline = make.template operator()<kMethodSets[i]>(), true)) || ...));
  }
  (std::make_index_sequence<kMethodSets.size()>{});
  return pipeline;
}

template <Effects own>
constexpr Effects everything_with() {
  constexpr Effects kAll =
      without(effect::of_scenes, effect::orthographic) | effect::statistics | effect::bins | method::culling | own;
  return without(kAll, refused_by_methods(kAll));
}

template <Effects perspective>
constexpr Pipeline method_pipeline(bool orthographic) {
  constexpr Effects kOrthographic = perspective | effect::orthographic;
  if (orthographic) return {&begin_frame<kOrthographic>, &draw_strip<kOrthographic>, &draw_over<kOrthographic>};
  return {&begin_frame<perspective>, &draw_strip<perspective>, &draw_over<perspective>};
}

/// `own`: the methods without culling, which agree with what the scene calls for.
Pipeline pipeline_of_method_with_effects(Effects own, bool orthographic);

}  // namespace zstrip::detail
