// Declared, not there: what code without an overlay may know of it.
#pragma once

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::overlay {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::overlay;
  template <Effects effects>
  static Status check(const FrameRequest&);
};

}  // namespace zstrip::detail::overlay
