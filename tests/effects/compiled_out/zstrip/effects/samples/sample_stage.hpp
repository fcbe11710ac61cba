// Declared, not there: what code without samples may know of them.
#pragma once

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::samples {

template <Effects effects>
Status begin_frame(FrameState& frame, const FrameRequest& request, std::span<std::byte> arena);

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::supersampled;
  template <Effects effects>
  static Status check(const FrameRequest&);
};

}  // namespace zstrip::detail::samples
