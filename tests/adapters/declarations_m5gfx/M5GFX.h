// Of M5GFX: its guard, by which it is recognised, and its device.
#ifndef __M5GFX_H__
#define __M5GFX_H__  // NOLINT
#include "../declarations/lgfx/device.hpp"

class M5GFX : public lgfx::LGFX_Device {};
#endif
