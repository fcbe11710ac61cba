// Shows a baked model on the display that the devicetree chooses. The model is that of the sketch Player; `zstrip bake
// MODEL -o scene.hpp --turntable` makes your own.
#include <cstddef>
#include <cstdint>

#include <zephyr/device.h>
#include <zephyr/drivers/display.h>
#include <zephyr/kernel.h>
#include <zephyr/sys/printk.h>
#include <zstrip_player/player.hpp>

#include "scene.hpp"
#include "zephyr_display.hpp"

static std::byte memory[24 * 1024];  // arena, a strip, and what moves
static zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);

int main() {
  const struct device* const display = DEVICE_DT_GET(DT_CHOSEN(zephyr_display));
  // Drivers that have several formats may begin with another one; those that have one refuse.
  (void)display_set_pixel_format(display, PIXEL_FORMAT_RGB_565);
  adapters::ZephyrDisplay panel(display);
  if (const zstrip::hal::Error error = panel.start(); error != zstrip::hal::Error::none) {
    printk("the display: %s\n", zstrip::hal::message(error));
    return 0;
  }
  (void)display_blanking_off(display);
  const bool opened = player.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView);
  if (!opened || !player.fit(panel)) {
    printk("%s\n", player.error());
    return 0;
  }
  for (std::uint32_t frames = 1;; ++frames) {
    player.play(k_uptime_get_32());
    if (!player.draw(panel)) {
      printk("%s\n", player.error());
      return 0;
    }
    if (frames % 16 == 0) printk("%u frames drawn\n", static_cast<unsigned>(frames));
  }
}
