// The Utah teapot in 128x128 pixels, in 4.8 KB.
#include "cortex_m/turntable.hpp"
#include "zstrip_scenes/teapot_meshlets.hpp"

int main() { return zstrip::board::Turntable<zstrip::scenes::teapot_meshlets, 128, 128, 4'880>::run(); }
