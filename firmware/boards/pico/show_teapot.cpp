// The Utah teapot on a panel of 240x240 pixels, ST7789, on SPI0 with DMA (pins.hpp): one strip is drawn while the other
// is being sent, and only tiles that changed are sent.
#include "cortex_m/systick.hpp"
#include "pico/panel_bus.hpp"
#include "pico/pins.hpp"
#include "portable/panel_program.hpp"
#include "portable/turntable_motion.hpp"
#include "zstrip_hal/changed_tiles.hpp"
#include "zstrip_hal/st7789.hpp"
#include "zstrip_scenes/teapot.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::board;

constexpr View kView{240, 240, PixelFormat::rgb565_swapped};
constexpr Budget kBudget{.bytes = 128 * 1024, .strip_rows = 16, .strip_buffers = 2};
// Low strips send less, and the bus is idle for a shorter time; bins transform no vertex twice for them.
constexpr Quality kLowStrips{
    .name = "low strips", .effects = effect::bins, .budget = {.strip_rows = 16, .modes = Modes::binned}};

using Player = ScenePlayer<TurntableMotion<scenes::teapot, kView, kBudget, 64, kLowStrips>, 2>;
constexpr hal::StripLayout kLayout{Player::kPlan.strips, Player::kPlan.strip_rows, Player::kPlan.strip_columns};

}  // namespace

int main() {
  static constinit PanelBus bus;
  bus.start();
  static constinit SysTickClock clock(kHertz);
  static constinit hal::St7789 panel(bus, clock);
  static constinit hal::ChangedTiles<decltype(panel), hal::changed_tiles(kLayout, kView.width)> changes(panel);
  return run_on_panel<Player>(changes, PanelReset{}, clock, PanelLight{});
}
