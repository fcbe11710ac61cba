// M5GFX is recognised by its guard; the sketch declares its device.
#ifndef __M5GFX_H__
#define __M5GFX_H__  // NOLINT
#include "../declarations/lgfx/device.hpp"

class M5GFX : public lgfx::LGFX_Device {};
#endif
