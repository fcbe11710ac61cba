// Declared, not there: what code without samples may know of them.
#pragma once

#include "zstrip/frame/checks.hpp"

namespace zstrip {

struct Frame::Access::Samples;

}  // namespace zstrip
