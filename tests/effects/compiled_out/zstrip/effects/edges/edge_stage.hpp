// Declared, not there: what code without edges may know of them.
#pragma once

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::edges {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::edges;
  template <Effects effects>
  static Status check(const FrameRequest&);
};

}  // namespace zstrip::detail::edges
