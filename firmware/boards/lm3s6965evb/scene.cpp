// Shows your own scene on the board's OLED, with its animation or rotation: ZSTRIP_SCENE names its header.
#include "lm3s6965evb/show.hpp"
#include "portable/baked_motion.hpp"

using zstrip::board::Oled;
static_assert(baked::kView.width == Oled::kWidth && baked::kView.height == Oled::kHeight &&
                  baked::kView.format == zstrip::PixelFormat::gray4,
              "bake for this display: --size 128x64 --format gray4");
static_assert(baked::kPlan.strip_columns % 2 == 0, "the OLED has two pixels a byte: bake with even --strip-columns");

int main() {
  zstrip::board::OledBus bus;
  return zstrip::board::show_on_oled<zstrip::board::BakedMotion>(bus);
}
