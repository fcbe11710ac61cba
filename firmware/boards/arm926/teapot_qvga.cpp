// The Utah teapot in 320x240 pixels.
#include "arm926/show.hpp"
#include "zstrip_scenes/teapot.hpp"

int main() { return zstrip::board::show_on_lcd<zstrip::scenes::teapot, zstrip::board::kQvga>(); }
