// The table of pipelines with a visibility method, for programs that learn the method at run time.
#include "zstrip/frame/pipelines_with_effects.hpp"
#include "zstrip/frame/visibility_stages.hpp"

namespace zstrip {
namespace {

/// One for each method and projection: what counts slows all of them alike.
constexpr Effects kAlways = without(effect::all, effect::orthographic) | effect::bins | method::culling;

template <Effects own>
constexpr Pipeline pipeline(bool orthographic) {
  constexpr Effects kPerspective = kAlways | own;
  constexpr Effects kOrthographic = kPerspective | effect::orthographic;
  if (orthographic) {
    return {&detail::begin_frame<kOrthographic>, &detail::draw_strip<kOrthographic>, &detail::draw_over<kOrthographic>};
  }
  return {&detail::begin_frame<kPerspective>, &detail::draw_strip<kPerspective>, &detail::draw_over<kPerspective>};
}

}  // namespace

Pipeline pipeline_of_method(Effects effects) {
  if (!methods_agree(effects)) return detail::refusing<Error::visibility>();
  const bool orthographic = effects.has(effect::orthographic);
  const Effects own = without(Effects{0, effects.methods}, method::culling);
  if (own == Effects{}) return pipeline<effect::depth_state>(orthographic);
  if (own == method::painter) return pipeline<method::painter>(orthographic);
  if (own == (method::painter | method::in_order)) return pipeline<method::painter | method::in_order>(orthographic);
  if (own == (method::painter | method::bsp)) return pipeline<method::painter | method::bsp>(orthographic);
  if (own == method::front_to_back) return pipeline<method::front_to_back>(orthographic);
  if (own == method::hierarchical_z) return pipeline<method::hierarchical_z>(orthographic);
  if (own == (method::front_to_back | method::hierarchical_z)) {
    return pipeline<method::front_to_back | method::hierarchical_z>(orthographic);
  }
  if (own == method::midpoint) return pipeline<method::midpoint>(orthographic);
  if (own == method::midpoint_safe) return pipeline<method::midpoint_safe>(orthographic);
  return detail::refusing<Error::visibility>();
}

}  // namespace zstrip
