// ring.obj in 240x240 pixels, rgb565_swapped. A sketch for Arduino with Arduino_GFX, written by `zstrip bake`.
// `gfx` is the panel, an ST7789. For another one write its class instead.
#include <Arduino_GFX_Library.h>
#include <zstrip.h>

#include "arduino_gfx.hpp"
#include "scene.hpp"

// The panel's pins in addition to SPI clock and data. An ESP32 has its flash at 6 to 11: take 2, 4 and 5 there.
constexpr int kDataCommand = 8, kReset = 9, kSelect = 10;  // kSelect = -1 without such a pin

constexpr zstrip::FitOptions kOptions{.strip_buffers = baked::kBudget.strip_buffers > 1 ? 2 : 1,
                                      .split_columns = baked::kBudget.split_columns,
                                      .strip_rows = baked::kPlan.strip_rows};
// Memory for arena and strips of the header's plan (--ram makes them smaller), for moving data, and for gaps.
std::byte memory[baked::kPlan.bytes() + kOptions.strip_buffers * baked::kPlan.strip_pixel_bytes(baked::kView) +
                 baked::kScene.instances.size_bytes() + baked::kScene.lines.size_bytes() + 96];
zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);
Arduino_HWSPI bus(kDataCommand, kSelect);
Arduino_ST7789 gfx(&bus, kReset, 0, true, 240, 240, 0, 0, 0, 80);
adapters::ArduinoGfx panel(gfx);

void setup() {
  Serial.begin(115200);
  if (panel.start() != zstrip::hal::Error::none) Serial.println("the panel does not start");
  const bool opened = player.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView);
  if (!opened || !player.fit(panel, kOptions)) Serial.println(player.error());
}

void loop() {
  player.play(millis());
  if (!player.draw(panel)) Serial.println(player.error());
}
