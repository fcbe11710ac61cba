// A room seen from inside in 128x128 pixels, with the preset for the least memory.
#include "cortex_m/turntable.hpp"
#include "zstrip_scenes/room.hpp"

int main() { return zstrip::board::Turntable<zstrip::scenes::room, 128, 128, 4'880, zstrip::quality::tiny>::run(); }
