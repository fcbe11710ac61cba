// zstrip on esp_lcd of ESP-IDF 5.0.1 or later, by DMA: panels on SPI, or on an 8080 bus.
// Needs the component esp_lcd, an IO handle and a panel handle that was reset, initialised and switched on. The strip
// buffers must be memory that DMA reaches: internal RAM, aligned to 4.
// Format: rgb565_swapped. The bus sends the bytes as they lie in memory (an 8080 bus: swap_color_bytes is not set).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <esp_idf_version.h>
#include <esp_lcd_panel_io.h>
#include <esp_lcd_panel_ops.h>
#include <freertos/FreeRTOS.h>
#include <freertos/semphr.h>
#include <zstrip_hal/display.hpp>

#if ESP_IDF_VERSION < ESP_IDF_VERSION_VAL(5, 0, 1)
#error esp_lcd.hpp needs ESP-IDF 5.0.1: 5.0 has no esp_lcd_panel_io_register_event_callbacks(). Install a later release.
#endif

namespace adapters {

class EspLcd {
 public:
  using Error = zstrip::hal::Error;
  static constexpr auto kFormat = zstrip::hal::DisplayFormat::rgb565_swapped;

  EspLcd(esp_lcd_panel_io_handle_t io, esp_lcd_panel_handle_t panel, std::uint16_t width, std::uint16_t height)
      : io_(io), panel_(panel), width_(width), height_(height) {}
  EspLcd(const EspLcd&) = delete;  // the callback has its address
  EspLcd& operator=(const EspLcd&) = delete;

  /// Call it once, before the first frame. Registers the callback of the IO handle. Error::bus: that failed.
  Error start() {
    const esp_lcd_panel_io_callbacks_t callbacks{.on_color_trans_done = &has_sent};
    prepare();
    return registered(esp_lcd_panel_io_register_event_callbacks(io_, &callbacks, this));
  }

  std::uint16_t width() const { return width_; }
  std::uint16_t height() const { return height_; }
  zstrip::hal::DisplayFormat format() const { return kFormat; }

  /// After a time-out the transfer continues, because it cannot be stopped: no new frame begins before it has ended.
  Error begin_frame() { return sent_ != nullptr ? wait() : Error::bus; }
  Error write(const zstrip::hal::Area& area, std::span<const std::byte> pixels) {
    if (!contains(width_, height_, area)) return Error::area;
    if (pixels.size() < bytes_per_row(area.width, kFormat) * area.height) return Error::pixels_too_small;
    sending_ = esp_lcd_panel_draw_bitmap(panel_, area.left, area.top, area.left + area.width, area.top + area.height,
                                         pixels.data()) == ESP_OK;
    return sending_ ? Error::none : Error::bus;
  }
  Error wait() {
    constexpr std::uint32_t kTimeout = 1000;  // ms
    if (!sending_) return Error::none;
    if (xSemaphoreTake(sent_, pdMS_TO_TICKS(kTimeout)) != pdTRUE) return Error::timeout;
    sending_ = false;
    return Error::none;
  }
  Error end_frame() { return Error::none; }

 protected:
  /// The other adapters of esp_lcd (esp_lcd_rgb.hpp, esp_lcd_dsi.hpp) call these functions. prepare() comes before the
  /// callback can, registered() after.
  void prepare() { sent_ = xSemaphoreCreateBinaryStatic(&storage_); }
  Error registered(esp_err_t said) {
    if (said != ESP_OK) sent_ = nullptr;
    return sent_ != nullptr ? Error::none : Error::bus;
  }
  esp_lcd_panel_handle_t panel() const { return panel_; }
  /// The driver has taken the strip: it says so in an interrupt, or within draw_bitmap(). Returns true if a task of
  /// higher priority was woken.
  bool end_write() {
    if (!xPortInIsrContext()) {
      xSemaphoreGive(sent_);
      return false;
    }
    BaseType_t woken = pdFALSE;
    xSemaphoreGiveFromISR(sent_, &woken);
    return woken == pdTRUE;
  }

 private:
  static bool has_sent(esp_lcd_panel_io_handle_t, esp_lcd_panel_io_event_data_t*, void* self) {
    return static_cast<EspLcd*>(self)->end_write();
  }

  esp_lcd_panel_io_handle_t io_;
  esp_lcd_panel_handle_t panel_;
  std::uint16_t width_, height_;
  StaticSemaphore_t storage_{};
  SemaphoreHandle_t sent_ = nullptr;
  bool sending_ = false;
};
static_assert(zstrip::hal::Display<EspLcd>);

}  // namespace adapters
