// Causes faults for tests, which are shown on bochs-display and the console.
#include "portable/faulting_player.hpp"
#include "riscv_virt/show.hpp"

namespace {
constexpr zstrip::View kView{320, 240, zstrip::PixelFormat::rgb565};
}

int main() { return zstrip::board::run_on_bochs_display<zstrip::board::FaultingPlayer, kView>(); }
