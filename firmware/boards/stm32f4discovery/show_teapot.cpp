// The Utah teapot on a panel of 320x240 pixels, ILI9341, on SPI1 with DMA (pins.hpp): one strip is drawn while the
// other is being sent.
#include "cortex_m/systick.hpp"
#include "portable/panel_program.hpp"
#include "portable/turntable_motion.hpp"
#include "stm32/dma_panel_bus.hpp"
#include "stm32f4discovery/pins.hpp"
#include "zstrip_hal/ili9341.hpp"
#include "zstrip_scenes/teapot.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::board;

constexpr View kView{320, 240, PixelFormat::rgb565_swapped};
constexpr Budget kBudget{.bytes = 100 * 1024, .strip_buffers = 2};
constexpr hal::DcsConfig kModule = hal::turned(hal::kIli9341Module240x320, hal::Rotation::by_90);
constexpr std::uint32_t kBy8 = 2;  // APB2's 80 MHz divided to 10 MHz

}  // namespace

int main() {
  start_panel_pins();
  stm32::DmaPanelBus<PanelDataCommand, PanelSelect> bus;
  if (bus.start(kBy8) != hal::Error::none) return 1;  // setting pins cannot fail
  SysTickClock clock(stm32::clocks().processor);
  hal::Ili9341 panel(bus, clock, kModule);
  return run_on_panel<ScenePlayer<TurntableMotion<scenes::teapot, kView, kBudget>, 2>>(panel, PanelReset{}, clock,
                                                                                       PanelLight{});
}
