// Declared, not there: what code without CSG may know of it.
#pragma once

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::csg {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::csg;
  template <Effects effects>
  static Status check(const FrameRequest&);
};

}  // namespace zstrip::detail::csg
