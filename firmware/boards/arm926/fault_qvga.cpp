// Causes faults for tests, which are shown on the LCD and the console.
#include "arm926/show.hpp"
#include "portable/faulting_player.hpp"

int main() { return zstrip::board::run_on_lcd<zstrip::board::FaultingPlayer, zstrip::board::kQvga>(); }
