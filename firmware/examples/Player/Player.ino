// A model on a panel in four calls: open, fit, play, draw. Your own: in a folder with zstrip's repository
//   host-sim/run bake MODEL -o scene.hpp --size 240x240 --format rgb565_swapped --turntable
// and put scene.hpp next to this sketch. The block is host-sim/scenes/models/block.obj.
#include <zstrip.h>
#include <zstrip_arduino.h>

#include "scene.hpp"

std::byte memory[20 * 1024];
zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects | zstrip::effect::overlay>);
zstrip::hal::ArduinoClock waiting;
zstrip::hal::ArduinoSpi bus(SPI, {.data_command = 8, .select = 10}, 15'000'000);  // pins; hertz
zstrip::hal::St7789 panel(bus, waiting);

void setup() {
  Serial.begin(115200);
  bus.start();
  zstrip::hal::ArduinoPin reset(9);
  (void)zstrip::hal::reset_panel(reset, waiting);
  if (panel.start() != zstrip::hal::Error::none) Serial.println("the panel does not start");
  player.show_text("", true, zstrip::kLargeFont);
  const bool opened = player.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView);
  if (!opened || !player.fit(panel)) Serial.println(player.error());
}

void loop() {
  player.play(millis());
  if (!player.draw(panel)) Serial.println(player.error());
}
