// The picture that a baked program leaves on the screen of tests/adapters.
#pragma once

namespace zstrip::package {

/// Returns 0 if the screen shows the picture of this file, raw RGB565 with the high byte first, and nothing was wrong;
/// else prints why not and returns 1.
int compare_screen(const char* picture);

}  // namespace zstrip::package
