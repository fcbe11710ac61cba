// Declared, not there: what code without edges may know of them.
#pragma once

#include "zstrip/frame/checks.hpp"

namespace zstrip {

struct Frame::Access::Edges {
  static bool called_for(const Frame&);
  static Rect with_apron(const Rect&, const View&);
  template <Effects effects>
  static void survey(Frame&);
  template <Effects effects, class... Arguments>
  static void resolve(const Arguments&...);
};

}  // namespace zstrip
