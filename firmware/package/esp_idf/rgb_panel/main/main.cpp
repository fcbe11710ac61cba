// Shows a baked model on an RGB panel with 480x272 pixels, without a picture in memory. glass.hpp has pins and timings.
// The model is that of the sketch Player; `zstrip bake MODEL -o show/ --project esp_idf --display rgb_panel` writes a
// program like this one for your own.
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <esp_lcd_panel_ops.h>
#include <esp_timer.h>
#include <zstrip_player/player.hpp>

#include "esp_lcd_rgb.hpp"
#include "glass.hpp"
#include "scene.hpp"

constexpr std::uint16_t kWidth = 480, kHeight = 272;
constexpr std::uint16_t kStripRows = 17;  // 16 strips. Fewer rows take less memory, and leave less time for each strip

static std::byte memory[48 * 1024];  // arena, a strip, and what moves
static zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);

extern "C" void app_main() {
  const esp_lcd_panel_handle_t driver = glass::create(kWidth, kHeight, kStripRows);
  static adapters::EspLcdRgb panel(driver, kWidth, kHeight, kStripRows);
  if (driver == nullptr || panel.start() != zstrip::hal::Error::none || esp_lcd_panel_init(driver) != ESP_OK) {
    std::puts("the panel does not start");
    return;
  }
  const bool opened = player.open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView);
  if (!opened || !player.fit(panel, {.strip_rows = kStripRows})) {
    std::puts(player.error());
    return;
  }
  for (unsigned frames = 0, late = 0;; ++frames) {
    player.play(static_cast<std::uint32_t>(esp_timer_get_time() / 1000));
    late += player.draw(panel) ? 0 : 1;
    if (frames == 0) glass::light();
    // The panel shows old rows in a frame that is late. More than a few: take a slower pixel clock, or a smaller model.
    if (frames % 1000 == 999) std::printf("%u of %u frames were late: %s\n", late, frames + 1, player.error());
  }
}
