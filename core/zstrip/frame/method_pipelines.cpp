// The table of pipelines with a visibility method, for programs that learn the method at run time.
#include "zstrip/frame/method_pipelines.hpp"

namespace zstrip {

Pipeline pipeline_of_method(Effects effects) {
  if (!methods_agree(effects) || effects.any(effect::depth_formats | effect::depth_ranges)) {
    return detail::refusing<Error::visibility>();
  }
  const bool orthographic = effects.has(effect::orthographic);
  const Effects own = without(Effects{0, effects.methods}, method::culling);
  constexpr Effects kBeyondTriangles = without(effect::of_scenes, effect::all);
  if (effects.any(own == Effects{} ? without(kBeyondTriangles, effect::depth_state) : kBeyondTriangles)) {
    return detail::pipeline_of_method_with_effects(own, orthographic);
  }
  return detail::pipeline_of_set(own, [orthographic]<Effects set>() {
    constexpr Effects kOwn = set == Effects{} ? effect::depth_state : set;
    return detail::method_pipeline<detail::kOfTriangles | kOwn>(orthographic);
  });
}

}  // namespace zstrip
