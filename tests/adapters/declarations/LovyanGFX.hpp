// Of LovyanGFX 1.2. A sketch has this library or M5GFX, never both.
#pragma once

#ifdef __M5GFX_H__
#error LovyanGFX.hpp beside M5GFX.h
#endif
#include "lgfx/device.hpp"
