// The compiler's header for Helium, in one place.
#pragma once

#include "zstrip/base/processor.hpp"

#if ZSTRIP_HAS_MVE
#include <arm_mve.h>
#endif
