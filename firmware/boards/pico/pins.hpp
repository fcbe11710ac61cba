// The wiring of the Raspberry Pi Pico and Pico 2; numbers are the GPn of their pinouts.
#pragma once

#include "pico/chip.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::board {

inline constexpr std::uint32_t kHertz = chip::hertz();

template <unsigned number>
struct Pin {
  hal::Error set(bool high) const {
    register_at(high ? chip::kPinsSet : chip::kPinsClear) = 1U << number;
    return hal::Error::none;
  }
  /// Sets the level first: a line that falls and rises again at once is a pulse.
  static void make_output(bool high) {
    register_at(high ? chip::kPinsSet : chip::kPinsClear) = 1U << number;
    register_at(chip::kPinsEnableOutput) = 1U << number;
    register_at(chip::pin_control(number)) = chip::kFunctionSio;
    chip::connect_output(number);
  }
};

// The console: GP0 sends, GP1 receives. The panel: GP18 clock, GP19 data (SPI0), and the lines below.
using PanelSelect = Pin<17>;
using PanelDataCommand = Pin<20>;
using PanelReset = Pin<21>;
using PanelLight = Pin<22>;

}  // namespace zstrip::board
