// A room seen from inside in 240x240 pixels, in 13 KB.
#include "cortex_m/turntable.hpp"
#include "zstrip_scenes/room.hpp"

int main() { return zstrip::board::Turntable<zstrip::scenes::room, 240, 240, 13'000>::run(); }
