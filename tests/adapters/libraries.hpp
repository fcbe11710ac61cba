// The adapters of firmware/examples/adapters, each on a stand-in for its library.
#pragma once

#include <memory>

#include "any_display.hpp"
#include "screen.hpp"

namespace zstrip::adapters_test {

/// `Parts` has the objects of a library and an adapter of them, which is started here.
template <class Parts>
class Opened final : public panel::DisplayAdapter<Opened<Parts>> {
 public:
  Opened() { screen().started = parts_.adapter.start(); }
  auto& display() { return parts_.adapter; }

 private:
  Parts parts_;
};

using Open = std::unique_ptr<panel::AnyDisplay> (*)();
std::unique_ptr<panel::AnyDisplay> open_tft_espi();
std::unique_ptr<panel::AnyDisplay> open_tft_espi_with_dma();  ///< the sketch has called initDMA()
std::unique_ptr<panel::AnyDisplay> open_lovyangfx();
std::unique_ptr<panel::AnyDisplay> open_arduino_gfx();
std::unique_ptr<panel::AnyDisplay> open_esp_lcd();
std::unique_ptr<panel::AnyDisplay> open_esp_lcd_dsi();         ///< the processor copies
std::unique_ptr<panel::AnyDisplay> open_esp_lcd_dsi_by_dma();  ///< with DMA2D
std::unique_ptr<panel::AnyDisplay> open_esp_lcd_rgb_framebuffer();
std::unique_ptr<panel::AnyDisplay> open_pico();
std::unique_ptr<panel::AnyDisplay> open_stm32();  ///< blocks
std::unique_ptr<panel::AnyDisplay> open_stm32_dma();
std::unique_ptr<panel::AnyDisplay> open_lvgl();
std::unique_ptr<panel::AnyDisplay> open_zephyr();              ///< low byte first
std::unique_ptr<panel::AnyDisplay> open_zephyr_swapped();      ///< high byte first
std::unique_ptr<panel::AnyDisplay> open_zephyr_mislabelled();  ///< high byte first, which the driver denies
std::unique_ptr<panel::AnyDisplay> open_zephyr_4_2();          ///< low byte first
std::unique_ptr<panel::AnyDisplay> open_zephyr_4_2_swapped();  ///< high byte first
std::unique_ptr<panel::AnyDisplay> open_sdl2();                ///< the real library

}  // namespace zstrip::adapters_test
