// A textured room seen from inside in 640x480 pixels of 32 bits; each pixel gets the exact texel.
#include "zstrip_scenes/room.hpp"
#include "riscv_virt/show.hpp"

namespace {
constexpr zstrip::View kView{640, 480, zstrip::PixelFormat::xrgb8888};
}

int main() { return zstrip::board::show_on_bochs_display<zstrip::scenes::room, kView, zstrip::quality::exact>(); }
