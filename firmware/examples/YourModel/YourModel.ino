// A model of yours, here a ring. In a folder with zstrip's repository, from any model file (.glb .obj .stl ...):
//   host-sim/run bake MODEL -o scene.hpp --size 240x240 --format rgb565_swapped --ram 20K --turntable
// and put scene.hpp next to this sketch; its first lines say how much flash and RAM it takes. The ring is
// host-sim/scenes/models/ring.obj.
#include <SPI.h>
#include <zstrip.h>
#include <zstrip_arduino.h>

#include "scene.hpp"

// The panel's pins in addition to SPI clock and data. Without a select pin: kSelect = -1, and .mode = SPI_MODE3 below.
constexpr int kDataCommand = 8, kReset = 9, kSelect = 10;
constexpr std::uint32_t kHertz = 15'000'000;  // the data sheet's limit; modules are commonly run at 40'000'000

baked::FixedRenderer renderer;
alignas(4) std::byte pixels[renderer.kStripBytes];

zstrip::hal::ArduinoClock waiting;
zstrip::hal::ArduinoSpi bus(SPI, {.data_command = kDataCommand, .select = kSelect}, kHertz);
zstrip::hal::St7789 panel(bus, waiting);

void setup() {
  Serial.begin(115200);
  bus.start();
  zstrip::hal::ArduinoPin reset(kReset);
  (void)zstrip::hal::reset_panel(reset, waiting);
  const zstrip::hal::Error error = panel.start();
  if (error != zstrip::hal::Error::none) Serial.println(zstrip::hal::message(error));
}

void loop() {
  static zstrip::Angle turn = 0;  // 65536 is a full one
  zstrip::Camera camera = baked::kCamera;
  // The camera stands at a distance of 4.1 units of the model (16.16), seen from above: 1/5 of a turn from the pole.
  if (!zstrip::orbit(camera, {0, 0, 0}, 65536 * 41 / 10, turn, 65536 / 5)) return;
  turn += 512;
  const zstrip::Status begun = renderer.begin_frame(camera);
  if (!begun) {
    Serial.println(zstrip::message(begun.error));
    return;
  }
  const auto shown =
      zstrip::hal::present(renderer, panel, {renderer.kPlan.strips, renderer.kPlan.strip_rows}, {pixels, {}});
  if (!shown) Serial.println(shown.draw ? zstrip::hal::message(shown.display) : zstrip::message(shown.draw.error));
}
