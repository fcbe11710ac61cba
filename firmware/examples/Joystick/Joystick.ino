// Two models, one of which a joystick moves: the scene's instances lie in RAM, so that the sketch can change their
// transforms between frames. Your own: in a folder with zstrip's repository
//   host-sim/run bake MODEL -o scene.hpp --size 240x240 --format rgb565_swapped --clipping on
// and put scene.hpp next to this sketch. The model here is firmware/examples/Joystick/scene.toml.
#include <zstrip.h>
#include <zstrip_arduino.h>

#include <algorithm>
#include <iterator>

#include "scene.hpp"

constexpr int kStickX = A0, kStickY = A1;  // pins
constexpr int kFullScale = 1023;           // of analogRead; on an ESP32 4095

std::byte memory[20 * 1024];
zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);
zstrip::hal::ArduinoClock waiting;
zstrip::hal::ArduinoSpi bus(SPI, {.data_command = 8, .select = 10}, 15'000'000);  // pins; hertz
zstrip::hal::St7789 panel(bus, waiting);

zstrip::Instance instances[std::size(baked::kInstances)];  // in the order of scene.toml
constexpr int kBlock = 0;

void setup() {
  Serial.begin(115200);
  bus.start();
  zstrip::hal::ArduinoPin reset(9);
  (void)zstrip::hal::reset_panel(reset, waiting);
  if (panel.start() != zstrip::hal::Error::none) Serial.println("the panel does not start");

  std::copy(std::begin(baked::kInstances), std::end(baked::kInstances), instances);
  zstrip::Scene scene = baked::kScene;
  scene.instances = instances;
  const zstrip::Turn still{.what = zstrip::Turning::nothing};
  const bool opened = player.open({scene, baked::kCamera, {}, still}, baked::kView);
  if (!opened || !player.fit(panel)) Serial.println(player.error());
}

// A header's unit of length is not the file's: lengths here are multiples of the block's.
constexpr zstrip::Fixed kHalfBlock = baked::kMeshes[kBlock].half_extent.x;

// The place on one axis (16.16) after a frame in which the stick stood at `reading`.
zstrip::Fixed pushed(zstrip::Fixed place, int reading) {
  const int push = reading - kFullScale / 2;
  if (push * push < kFullScale * kFullScale / 400) return place;  // near the middle the stick rests
  return std::clamp<zstrip::Fixed>(place + kHalfBlock / 8 * push / kFullScale, -3 * kHalfBlock, 3 * kHalfBlock);
}

void loop() {
  zstrip::Transform& block = instances[kBlock].transform;  // the last number of a row is the place on x, y, z
  block.m[0][3] = pushed(block.m[0][3], analogRead(kStickX));
  block.m[2][3] = pushed(block.m[2][3], analogRead(kStickY));
  if (!player.draw(panel)) Serial.println(player.error());
}
