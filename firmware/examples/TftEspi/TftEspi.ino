// ring.obj in 240x240 pixels, rgb565_swapped. A sketch for Arduino with TFT_eSPI, written by `zstrip bake`.
// TFT_eSPI knows the panel and its pins: by its User_Setup.h, or by the flags of a platformio.ini.
#include <TFT_eSPI.h>
#include <zstrip.h>

#include "scene.hpp"
#include "tft_espi.hpp"

constexpr zstrip::FitOptions kOptions{.strip_buffers = baked::kBudget.strip_buffers > 1 ? 2 : 1,
                                      .split_columns = baked::kBudget.split_columns,
                                      .strip_rows = baked::kPlan.strip_rows};
// Memory for arena and strips of the header's plan (--ram makes them smaller), for moving data, and for gaps.
std::byte memory[baked::kPlan.bytes() + kOptions.strip_buffers * baked::kPlan.strip_pixel_bytes(baked::kView) +
                 baked::kScene.instances.size_bytes() + baked::kScene.lines.size_bytes() + 96];
zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);
TFT_eSPI tft;
adapters::TftEspi panel(tft);

void setup() {
  Serial.begin(115200);
  if (panel.start() != zstrip::hal::Error::none) Serial.println("TFT_eSPI has no DMA for this board");
  tft.setRotation(0);
  const bool opened = player.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView);
  if (!opened || !player.fit(panel, kOptions)) Serial.println(player.error());
}

void loop() {
  player.play(millis());
  if (!player.draw(panel)) Serial.println(player.error());
}
