// A stand-in for esp_lcd and the semaphore of FreeRTOS.
#include "esp_lcd.hpp"

#include <utility>

#include "libraries.hpp"

namespace {

using namespace zstrip::adapters_test;

esp_lcd_panel_io_callbacks_t callbacks;
void* context;

struct EspLcdParts {
  adapters::EspLcd adapter{nullptr, nullptr, kWidth, kHeight};
};

}  // namespace

esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t, const esp_lcd_panel_io_callbacks_t* set,
                                                    void* with) {
  callbacks = *set;
  context = with;
  return screen().fault == Fault::start ? 0x103 : ESP_OK;
}
esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t, int left, int top, int right, int bottom,
                                    const void* colours) {
  if (screen().fault == Fault::write) return 0x101;
  screen().begin(area_of(left, top, right - left, bottom - top), colours, First::high);
  return ESP_OK;
}

SemaphoreHandle_t xSemaphoreCreateBinaryStatic(StaticSemaphore_t* storage) {
  storage->given = false;
  return storage;
}
BaseType_t xSemaphoreTake(SemaphoreHandle_t semaphore, TickType_t) {
  if (screen().busy() && screen().fault != Fault::transfer) {
    screen().end();
    esp_lcd_panel_io_event_data_t event{};
    callbacks.on_color_trans_done(nullptr, &event, context);
  }
  return std::exchange(semaphore->given, false) ? pdTRUE : pdFALSE;
}
BaseType_t xSemaphoreGiveFromISR(SemaphoreHandle_t semaphore, BaseType_t* woken) {
  semaphore->given = true;
  *woken = pdTRUE;
  return pdTRUE;
}

namespace zstrip::adapters_test {
std::unique_ptr<panel::AnyDisplay> open_esp_lcd() { return std::make_unique<Opened<EspLcdParts>>(); }
}  // namespace zstrip::adapters_test
