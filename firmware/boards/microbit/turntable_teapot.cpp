// The Utah teapot in 240x240 pixels, in 13 KB.
#include "cortex_m/turntable.hpp"
#include "zstrip_scenes/teapot_meshlets.hpp"

int main() { return zstrip::board::Turntable<zstrip::scenes::teapot_meshlets, 240, 240, 13'000>::run(); }
