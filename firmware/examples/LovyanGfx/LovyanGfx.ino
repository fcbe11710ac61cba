// ring.obj in 240x240 pixels, rgb565_swapped. A sketch for Arduino with LovyanGFX, written by `zstrip bake`.
// The class Device names the panel, an ST7789. For another one, or a board that LovyanGFX knows, write yours instead.
#include <LovyanGFX.hpp>
#include <zstrip.h>

#include "lovyangfx.hpp"
#include "scene.hpp"

// The panel's pins in addition to SPI clock and data. An ESP32 has its flash at 6 to 11: take 2, 4 and 5 there.
constexpr int kDataCommand = 8, kReset = 9, kSelect = 10;  // kSelect = -1 without such a pin
constexpr std::uint32_t kHertz = 40'000'000;

constexpr zstrip::FitOptions kOptions{.strip_buffers = baked::kBudget.strip_buffers > 1 ? 2 : 1,
                                      .split_columns = baked::kBudget.split_columns,
                                      .strip_rows = baked::kPlan.strip_rows};
// Memory for arena and strips of the header's plan (--ram makes them smaller), for moving data, and for gaps.
std::byte memory[baked::kPlan.bytes() + kOptions.strip_buffers * baked::kPlan.strip_pixel_bytes(baked::kView) +
                 baked::kScene.instances.size_bytes() + baked::kScene.lines.size_bytes() + 96];
zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);

// SCK and MOSI are the board's usual pins of SPI clock and data.
class Device : public lgfx::LGFX_Device {
 public:
  Device() {
    auto wires = bus_.config();
    wires.freq_write = kHertz;
    wires.pin_sclk = SCK;
    wires.pin_mosi = MOSI;
    wires.pin_dc = kDataCommand;
    bus_.config(wires);
    auto glass = panel_.config();
    glass.pin_cs = kSelect;
    glass.pin_rst = kReset;
    glass.panel_width = 240;
    glass.panel_height = 240;
    glass.readable = false;
    glass.invert = true;
    panel_.config(glass);
    panel_.setBus(&bus_);
    setPanel(&panel_);
  }

 private:
  lgfx::Bus_SPI bus_;
  lgfx::Panel_ST7789 panel_;
};
Device device;
adapters::LovyanGfx panel(device);

void setup() {
  Serial.begin(115200);
  if (panel.start() != zstrip::hal::Error::none) Serial.println("LovyanGFX finds no panel");
  device.setRotation(0);
  const bool opened = player.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView);
  if (!opened || !player.fit(panel, kOptions)) Serial.println(player.error());
}

void loop() {
  player.play(millis());
  if (!player.draw(panel)) Serial.println(player.error());
}
