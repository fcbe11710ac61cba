// The Utah teapot on a panel of 320x240 pixels, ILI9341, on SPI2 (pins.hpp). Polled, because emulators do not have this
// chip's DMA; stm32f4discovery uses DMA.
#include "cortex_m/systick.hpp"
#include "netduinoplus2/pins.hpp"
#include "portable/panel_program.hpp"
#include "portable/turntable_motion.hpp"
#include "stm32/panel_bus.hpp"
#include "zstrip_hal/ili9341.hpp"
#include "zstrip_scenes/teapot.hpp"

namespace {

using namespace zstrip;
using namespace zstrip::board;

constexpr View kView{320, 240, PixelFormat::rgb565_swapped};
constexpr Budget kBudget{.bytes = 100 * 1024, .strip_buffers = 1};
constexpr hal::DcsConfig kModule = hal::turned(hal::kIli9341Module240x320, hal::Rotation::by_90);
constexpr std::uint32_t kBy4 = 1;  // APB1's 40 MHz divided to 10 MHz

}  // namespace

int main() {
  start_panel_pins();
  stm32::PolledPanelBus<PanelDataCommand, PanelSelect> bus(kPanelSpi);
  if (bus.start(kBy4) != hal::Error::none) return 1;  // setting pins cannot fail
  SysTickClock clock(stm32::clocks().processor);
  hal::Ili9341 panel(bus, clock, kModule);
  return run_on_panel<ScenePlayer<TurntableMotion<scenes::teapot, kView, kBudget>>>(panel, PanelReset{}, clock);
}
