// Declared, not there: what code without samples may know of them.
#pragma once

#include "zstrip/frame/checks.hpp"

namespace zstrip {

struct Frame::Access::Samples {
  template <Effects effects, class... Arguments>
  static Status begin_frame(const Arguments&...);
  template <class... Arguments>
  static Status strip(const Arguments&...);
  template <Effects effects, class... Arguments>
  static void resolve(const Arguments&...);
};

}  // namespace zstrip
