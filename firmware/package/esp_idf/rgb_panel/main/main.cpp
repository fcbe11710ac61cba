// Shows a baked model on an RGB panel with 480x272 pixels, without a picture in memory. The model is that of the sketch
// Player; `zstrip bake MODEL -o scene.hpp --turntable` makes your own.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iterator>

#include <driver/gpio.h>
#include <esp_lcd_panel_ops.h>
#include <esp_lcd_panel_rgb.h>
#include <esp_timer.h>
#include <zstrip_player/player.hpp>

#include "esp_lcd_rgb.hpp"
#include "scene.hpp"

// The pins of an ESP32-4827S043, blue first, and the timings of its panel. Other boards have others.
constexpr int kColours[] = {8, 3, 46, 9, 1, 5, 6, 7, 15, 16, 4, 45, 48, 47, 21, 14};
constexpr int kPixelClock = 42, kColumns = 39, kRows = 41, kEnable = 40, kBacklight = 2;
constexpr std::uint16_t kWidth = 480, kHeight = 272;
constexpr std::uint16_t kStripRows = 17;  // 16 strips. Fewer rows take less memory, and leave less time for each strip
constexpr unsigned kHertz = 9'000'000;

static std::byte memory[48 * 1024];  // arena, a strip, and what moves
static zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);

static gpio_num_t pin(int number) { return static_cast<gpio_num_t>(number); }

// Returns null if the panel does not start.
static esp_lcd_panel_handle_t start_glass() {
  esp_lcd_rgb_panel_config_t config{};
  config.clk_src = LCD_CLK_SRC_DEFAULT;
  config.timings.pclk_hz = kHertz;
  config.timings.h_res = kWidth;
  config.timings.v_res = kHeight;
  config.timings.hsync_pulse_width = 4;
  config.timings.hsync_back_porch = 43;
  config.timings.hsync_front_porch = 8;
  config.timings.vsync_pulse_width = 4;
  config.timings.vsync_back_porch = 12;
  config.timings.vsync_front_porch = 8;
  config.timings.flags.pclk_active_neg = 1;
  config.data_width = std::size(kColours);
  config.bounce_buffer_size_px = kWidth * kStripRows;
  config.hsync_gpio_num = pin(kColumns);
  config.vsync_gpio_num = pin(kRows);
  config.de_gpio_num = pin(kEnable);
  config.pclk_gpio_num = pin(kPixelClock);
  config.disp_gpio_num = pin(-1);
  std::transform(std::begin(kColours), std::end(kColours), std::begin(config.data_gpio_nums), pin);
  config.flags.no_fb = 1;
  esp_lcd_panel_handle_t glass = nullptr;
  return esp_lcd_new_rgb_panel(&config, &glass) == ESP_OK ? glass : nullptr;
}

extern "C" void app_main() {
  const esp_lcd_panel_handle_t glass = start_glass();
  static adapters::EspLcdRgb panel(glass, kWidth, kHeight, kStripRows);
  if (glass == nullptr || panel.start() != zstrip::hal::Error::none || esp_lcd_panel_init(glass) != ESP_OK) {
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
    if (frames == 0) {
      gpio_set_direction(pin(kBacklight), GPIO_MODE_OUTPUT);
      gpio_set_level(pin(kBacklight), 1);
    }
    // The panel shows old rows in a frame that is late. More than a few: take a slower pixel clock, or a smaller model.
    if (frames % 1000 == 999) std::printf("%u of %u frames were late: %s\n", late, frames + 1, player.error());
  }
}
