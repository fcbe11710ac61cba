// The Utah teapot on a panel of 128x128 pixels, ST7735, on SPI1 (pins.hpp), in 4.8 KB.
#include "cortex_m/systick.hpp"
#include "portable/panel_program.hpp"
#include "portable/turntable_motion.hpp"
#include "stm32/panel_bus.hpp"
#include "stm32vldiscovery/pins.hpp"
#include "zstrip_hal/st7735.hpp"
#include "zstrip_scenes/teapot_meshlets.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::board;

constexpr View kView{128, 128, PixelFormat::rgb565_swapped};
constexpr Budget kBudget{.bytes = 4'720, .split_columns = true, .strip_buffers = 1};
// The usual module of 1.44 inches.
constexpr hal::DcsConfig kModule{.width = 128,
                                 .height = 128,
                                 .column_offset = 2,
                                 .row_offset = 3,
                                 .columns_reversed = true,
                                 .rows_reversed = true,
                                 .bgr = true};
constexpr std::uint32_t kBy2 = 0;  // 4 MHz

}  // namespace

int main() {
  start_panel_pins();
  stm32::PolledPanelBus<PanelDataCommand, PanelSelect> bus(kPanelSpi);
  if (bus.start(kBy2) != hal::Error::none) return 1;  // setting pins cannot fail
  SysTickClock clock(kHertz);
  hal::St7735 panel(bus, clock, kModule);
  return run_on_panel<ScenePlayer<TurntableMotion<scenes::teapot_meshlets, kView, kBudget>>>(panel, PanelReset{},
                                                                                             clock);
}
