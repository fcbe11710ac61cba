// The table of pipelines with a visibility method, for programs that learn the method at run time.
#include "zstrip/frame/method_pipelines.hpp"

namespace zstrip {
namespace {

template <Effects own>
constexpr Pipeline pipeline(bool orthographic) {
  return detail::method_pipeline<detail::kOfTriangles | own>(orthographic);
}

}  // namespace

Pipeline pipeline_of_method(Effects effects) {
  if (!methods_agree(effects) || effects.any(effect::depth_formats | effect::depth_ranges)) {
    return detail::refusing<Error::visibility>();
  }
  const bool orthographic = effects.has(effect::orthographic);
  const Effects own = without(Effects{0, effects.methods}, method::culling);
  constexpr Effects kBeyondTriangles =
      effect::depth_state | effect::fragments | effect::vertex_light | effect::surfaces;
  if (effects.any(own == Effects{} ? without(kBeyondTriangles, effect::depth_state) : kBeyondTriangles)) {
    return detail::pipeline_of_method_with_effects(own, orthographic);
  }
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
