// A sketch includes this header to get all of zstrip. Arduino finds a library by a header of this kind.
#pragma once

#include "zstrip/base/language.hpp"

// Some boards' Arduino.h defines macros with the names of functions of the C++ library and of zstrip.
#pragma push_macro("abs")
#pragma push_macro("max")
#pragma push_macro("min")
#pragma push_macro("round")
#undef abs
#undef max
#undef min
#undef round

// Sketches include these, too, and they do not compile with the macros.
#include <algorithm>
#include <iterator>

#include "zstrip/area.hpp"
#include "zstrip/zstrip.hpp"
#include "zstrip_hal/bit_banged_i2c.hpp"
#include "zstrip_hal/bit_banged_spi.hpp"
#include "zstrip_hal/co5300.hpp"
#include "zstrip_hal/gc9a01.hpp"
#include "zstrip_hal/i2c.hpp"
#include "zstrip_hal/ili9341.hpp"
#include "zstrip_hal/ili9342.hpp"
#include "zstrip_hal/ili9488.hpp"
#include "zstrip_hal/parallel_bus.hpp"
#include "zstrip_hal/present.hpp"
#include "zstrip_hal/qspi.hpp"
#include "zstrip_hal/second_core.hpp"
#include "zstrip_hal/sh8601.hpp"
#include "zstrip_hal/ssd0323.hpp"
#include "zstrip_hal/ssd1306.hpp"
#include "zstrip_hal/ssd1351.hpp"
#include "zstrip_hal/ssd1680.hpp"
#include "zstrip_hal/st7735.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_hal/st77916.hpp"
#include "zstrip_hal/st7796.hpp"
#include "zstrip_player/pick_with.hpp"

#pragma pop_macro("round")
#pragma pop_macro("min")
#pragma pop_macro("max")
#pragma pop_macro("abs")
