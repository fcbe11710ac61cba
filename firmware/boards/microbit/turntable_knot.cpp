// A textured, lit knot of 5120 triangles in 240x240 pixels, in 13 KB.
#include "cortex_m/turntable.hpp"
#include "zstrip_scenes/knot_meshlets.hpp"

int main() { return zstrip::board::Turntable<zstrip::scenes::knot_textured, 240, 240, 13'000>::run(); }
