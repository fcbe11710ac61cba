// Shows a baked model on an ST7789 with 240x240 pixels on SPI. The model is that of the sketch Player; `zstrip bake
// MODEL -o show/ --project esp_idf` writes a program like this one for your own.
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <driver/gpio.h>
#include <driver/spi_master.h>
#include <esp_lcd_panel_vendor.h>
#include <esp_timer.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>
#include <zstrip_player/player.hpp>

#include "esp_lcd.hpp"
#include "scene.hpp"

// The panel's pins, on an ESP32. Other chips have other ones. Without a select pin: kSelect -1 and kMode 3.
constexpr int kClock = 18, kData = 23, kDataCommand = 2, kReset = 4, kSelect = 5, kMode = 0;
constexpr unsigned kHertz = 40'000'000;

static std::byte memory[48 * 1024];  // arena, two strips, and what moves
static zstrip::Player player(memory, zstrip::drawn_with<baked::kEffects>);

/// Returns false if the panel does not start.
static bool start_glass(esp_lcd_panel_io_handle_t& io, esp_lcd_panel_handle_t& glass) {
  spi_bus_config_t bus{};
  bus.mosi_io_num = kData;
  bus.miso_io_num = -1;
  bus.sclk_io_num = kClock;
  bus.quadwp_io_num = -1;
  bus.quadhd_io_num = -1;
  bus.max_transfer_sz = sizeof memory;
  if (spi_bus_initialize(SPI2_HOST, &bus, SPI_DMA_CH_AUTO) != ESP_OK) return false;

  esp_lcd_panel_io_spi_config_t wires{};
  wires.cs_gpio_num = static_cast<gpio_num_t>(kSelect);
  wires.dc_gpio_num = static_cast<gpio_num_t>(kDataCommand);
  wires.spi_mode = kMode;
  wires.pclk_hz = kHertz;
  wires.trans_queue_depth = 10;
  wires.lcd_cmd_bits = 8;
  wires.lcd_param_bits = 8;
  if (esp_lcd_new_panel_io_spi((esp_lcd_spi_bus_handle_t)SPI2_HOST, &wires, &io) != ESP_OK) return false;

  esp_lcd_panel_dev_config_t config{};
  config.reset_gpio_num = static_cast<gpio_num_t>(kReset);
  config.bits_per_pixel = 16;
  if (esp_lcd_new_panel_st7789(io, &config, &glass) != ESP_OK) return false;
  esp_lcd_panel_reset(glass);
  esp_lcd_panel_init(glass);
  esp_lcd_panel_invert_color(glass, true);
  return esp_lcd_panel_disp_on_off(glass, true) == ESP_OK;
}

extern "C" void app_main() {
  esp_lcd_panel_io_handle_t io = nullptr;
  esp_lcd_panel_handle_t glass = nullptr;
  const bool has_glass = start_glass(io, glass);
  static adapters::EspLcd panel(io, glass, 240, 240);
  if (!has_glass || panel.start() != zstrip::hal::Error::none) {
    std::puts("the panel does not start");
    return;
  }
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
