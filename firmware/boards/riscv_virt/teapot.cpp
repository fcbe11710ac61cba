// The Utah teapot in 320x240 pixels of 16 bits.
#include "zstrip_scenes/teapot.hpp"
#include "riscv_virt/show.hpp"

namespace {
constexpr zstrip::View kView{320, 240, zstrip::PixelFormat::rgb565};
}

int main() { return zstrip::board::show_on_bochs_display<zstrip::scenes::teapot, kView>(); }
