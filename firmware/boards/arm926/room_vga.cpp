// A textured room seen from inside in 640x480 pixels; each pixel gets the exact texel.
#include "arm926/show.hpp"
#include "zstrip_scenes/room.hpp"

int main() { return zstrip::board::show_on_lcd<zstrip::scenes::room, zstrip::board::kVga, zstrip::quality::exact>(); }
