// A stand-in for esp_lcd and the semaphore of FreeRTOS.
#include "esp_lcd.hpp"

#include <utility>

#include "esp_lcd_driver.hpp"
#include "libraries.hpp"

esp_lcd_panel_t zstrip::adapters_test::panel_on_spi{[](const zstrip::hal::Area& area, const void* pixels) {
  screen().begin(area, pixels, First::high);
  return ESP_OK;
}};

namespace {

using namespace zstrip::adapters_test;

bool in_interrupt = false;

struct EspLcdParts {
  adapters::EspLcd adapter{nullptr, &panel_on_spi, kWidth, kHeight};
};

}  // namespace

esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t,
                                                    const esp_lcd_panel_io_callbacks_t* callbacks, void* context) {
  return register_callback([done = callbacks->on_color_trans_done, context] {
    esp_lcd_panel_io_event_data_t event{};
    done(nullptr, &event, context);
  });
}
esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int left, int top, int right, int bottom,
                                    const void* colours) {
  if (screen().fault == Fault::write) return 0x101;
  return panel->draw(area_of(left, top, right - left, bottom - top), colours);
}

BaseType_t xPortInIsrContext() { return in_interrupt ? pdTRUE : pdFALSE; }
SemaphoreHandle_t xSemaphoreCreateBinaryStatic(StaticSemaphore_t* storage) {
  storage->given = false;
  return storage;
}
BaseType_t xSemaphoreTake(SemaphoreHandle_t semaphore, TickType_t) {
  if (screen().busy() && screen().fault != Fault::transfer) {
    screen().end();
    in_interrupt = true;
    has_taken();
    in_interrupt = false;
  }
  return std::exchange(semaphore->given, false) ? pdTRUE : pdFALSE;
}
BaseType_t xSemaphoreGive(SemaphoreHandle_t semaphore) {
  if (in_interrupt) screen().complain("a call that interrupts must not make");
  return std::exchange(semaphore->given, true) ? pdFALSE : pdTRUE;
}
BaseType_t xSemaphoreGiveFromISR(SemaphoreHandle_t semaphore, BaseType_t* woken) {
  if (!in_interrupt) screen().complain("a call for interrupts alone");
  semaphore->given = true;
  *woken = pdTRUE;
  return pdTRUE;
}

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_esp_lcd() { return std::make_unique<Opened<EspLcdParts>>(); }
}  // namespace zstrip::adapters_test
