// One for each method that the tables of `zstrip bench` measure.
#include "visibility/uncounted_pipelines.hpp"

#include "zstrip/frame/visibility_stages.hpp"

namespace zstrip::sim {
namespace {

constexpr Effects kOfTriangles = without(effect::all, effect::orthographic | effect::statistics);

template <Effects own>
constexpr Pipeline pipeline() {
  constexpr Effects kEffects = kOfTriangles | own;
  return {&detail::begin_frame<kEffects>, &detail::draw_strip<kEffects>, &detail::draw_over<kEffects>};
}

}  // namespace

Pipeline uncounted_pipeline(Effects effects) {
  const Effects own{0, effects.methods};
  // Bins are for plans that have them; these have none.
  if (!(kOfTriangles | effect::bins | own).has(effects)) return pipeline_for(effects);
  if (own == method::painter) return pipeline<method::painter>();
  if (own == method::front_to_back) return pipeline<method::front_to_back>();
  if (own == method::hierarchical_z) return pipeline<method::hierarchical_z>();
  if (own == (method::front_to_back | method::hierarchical_z)) {
    return pipeline<method::front_to_back | method::hierarchical_z>();
  }
  if (own == method::midpoint) return pipeline<method::midpoint>();
  if (own == method::midpoint_safe) return pipeline<method::midpoint_safe>();
  return pipeline_for(effects);
}

}  // namespace zstrip::sim
