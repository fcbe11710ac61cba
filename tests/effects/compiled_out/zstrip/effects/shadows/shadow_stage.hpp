// Declared, not there: what code without shadows may know of them.
#pragma once

#include "zstrip/frame/access.hpp"

namespace zstrip {

struct Frame::Access::Shadows {
  template <Effects effects, class... Arguments>
  static Status begin_frame(const Arguments&...);
  template <Effects effects, class... Arguments>
  static Status prepare(const Arguments&...);
  template <Effects effects, class... Arguments>
  static Status draw(const Arguments&...);
};

}  // namespace zstrip
