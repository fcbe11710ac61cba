// Of M5GFX: its guard, by which it is recognised.
#ifndef __M5GFX_H__
#define __M5GFX_H__  // NOLINT
#include "../declarations/lgfx/device.hpp"
#endif
