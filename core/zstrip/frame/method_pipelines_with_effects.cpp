// The pipelines with a visibility method for scenes with fog, alpha, local light, quadrics or rules of depth.
#include "zstrip/frame/method_pipelines.hpp"

namespace zstrip::detail {

Pipeline pipeline_of_method_with_effects(Effects own, bool orthographic) {
  return pipeline_of_set(
      own, [orthographic]<Effects set>() { return method_pipeline<everything_with<set>()>(orthographic); });
}

}  // namespace zstrip::detail
