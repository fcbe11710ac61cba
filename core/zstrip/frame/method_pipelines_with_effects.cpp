// The pipelines with a visibility method for scenes with fog, alpha, local light, quadrics or rules of depth.
#include "zstrip/frame/method_pipelines.hpp"

namespace zstrip::detail {
namespace {

template <Effects own>
constexpr Pipeline pipeline(bool orthographic) {
  return method_pipeline<everything_with<own>()>(orthographic);
}

}  // namespace

Pipeline pipeline_of_method_with_effects(Effects own, bool orthographic) {
  if (own == Effects{}) return pipeline<Effects{}>(orthographic);
  if (own == method::painter) return pipeline<method::painter>(orthographic);
  if (own == method::front_to_back) return pipeline<method::front_to_back>(orthographic);
  if (own == method::hierarchical_z) return pipeline<method::hierarchical_z>(orthographic);
  if (own == (method::front_to_back | method::hierarchical_z)) {
    return pipeline<method::front_to_back | method::hierarchical_z>(orthographic);
  }
  if (own == method::midpoint) return pipeline<method::midpoint>(orthographic);
  if (own == method::midpoint_safe) return pipeline<method::midpoint_safe>(orthographic);
  return refusing<Error::visibility>();
}

}  // namespace zstrip::detail
