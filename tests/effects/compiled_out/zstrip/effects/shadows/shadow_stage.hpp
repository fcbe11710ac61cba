// Declared, not there: what code without shadows may know of them.
#pragma once

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::shadows {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::shadows;
  template <Effects effects>
  static Status check(const FrameRequest&);
};

}  // namespace zstrip::detail::shadows
