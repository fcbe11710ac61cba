// Of LovyanGFX 1.2. A sketch has this library or M5GFX, never both.
#pragma once

#ifdef __M5GFX_H__
#error LovyanGFX.hpp beside M5GFX.h
#endif
#include "lgfx/device.hpp"

namespace lgfx {

/// The names that a sketch calls.
class Bus_SPI : public IBus {
 public:
  struct config_t {
    std::uint32_t freq_write = 16000000;
    std::int16_t pin_sclk = -1, pin_mosi = -1, pin_dc = -1;
  };
  const config_t& config() const { return config_; }
  void config(const config_t& config) { config_ = config; }

 private:
  config_t config_;
};

class Panel_ST7789 : public Panel_Device {
 public:
  struct config_t {
    std::int16_t pin_cs = -1, pin_rst = -1;
    std::uint16_t panel_width = 240, panel_height = 320, offset_x = 0, offset_y = 0;
    bool readable = true, invert = false;
  };
  const config_t& config() const { return config_; }
  void config(const config_t& config) { config_ = config; }
  void setBus(IBus* bus) { bus_ = bus; }

 private:
  config_t config_;
  IBus* bus_ = nullptr;
};

}  // namespace lgfx
