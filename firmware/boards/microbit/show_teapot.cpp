// The Utah teapot on a panel of 240x240 pixels, ST7789, at the edge connector (pins.hpp), in 13 KB.
#include "microbit/pins.hpp"
#include "microbit/timer.hpp"
#include "portable/panel_program.hpp"
#include "portable/turntable_motion.hpp"
#include "zstrip_hal/bit_banged_spi.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_scenes/teapot_meshlets.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::board;

constexpr View kView{240, 240, PixelFormat::rgb565_swapped};
constexpr Budget kBudget{.bytes = 13'000, .split_columns = true, .strip_buffers = 1};

}  // namespace

int main() {
  start_panel_pins();
  start_timer();
  hal::BitBangedSpi bus(PanelClock{}, PanelData{}, PanelDataCommand{}, PanelSelect{});
  TimerClock clock;
  hal::St7789 panel(bus, clock);
  if (bus.start() != hal::Error::none) return 1;  // setting pins cannot fail
  return run_on_panel<ScenePlayer<TurntableMotion<scenes::teapot_meshlets, kView, kBudget>>>(panel, PanelReset{},
                                                                                             clock);
}
