// Declared, not there: what code without products of solids may know of them.
#pragma once

#include "zstrip/frame/access.hpp"

namespace zstrip {

struct Frame::Access::Csg {
  template <Effects effects, class... Arguments>
  static void prepare(const Arguments&...);
  template <Effects effects, class... Arguments>
  static void draw(const Arguments&...);
};

}  // namespace zstrip
