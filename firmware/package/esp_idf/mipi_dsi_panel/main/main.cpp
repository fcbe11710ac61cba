// Shows a baked model on a MIPI-DSI panel with 1024x600 pixels. glass.hpp has pins and timings. The model is that of
// the sketch Player; `zstrip bake MODEL -o show/ --project esp_idf --display mipi_dsi_panel` writes a program like this
// one for your own.
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>
#include <zstrip_player/player.hpp>

#include "esp_lcd_dsi.hpp"
#include "glass.hpp"
#include "scene.hpp"

constexpr std::uint16_t kWidth = 1024, kHeight = 600;

static std::byte memory[160 * 1024];  // arena, two strips, and what moves
static zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);

extern "C" void app_main() {
  const esp_lcd_panel_handle_t driver = glass::create(kWidth, kHeight);
  static adapters::EspLcdDsi panel(driver, kWidth, kHeight);
  if (driver == nullptr || panel.start() != zstrip::hal::Error::none) {
    std::puts("the panel does not start");
    return;
  }
  glass::light();
  const bool opened = player.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView);
  if (!opened || !player.fit(panel, {.strip_buffers = 2})) {
    std::puts(player.error());
    return;
  }
  for (;;) {
    player.play(static_cast<std::uint32_t>(esp_timer_get_time() / 1000));
    if (!player.draw(panel)) std::puts(player.error());
    vTaskDelay(1);  // the idle task runs, which the watchdog wants
  }
}
