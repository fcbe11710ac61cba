// Single pins of the micro:bit, by their numbers on the nRF51822. Source: nRF51 series reference manual, chapter 13.
#pragma once

#include <cstdint>

#include "cortex_m/registers.hpp"
#include "zstrip_hal/output_pin.hpp"

namespace zstrip::board {

template <unsigned number>
struct Pin {
  hal::Error set(bool high) const {
    constexpr std::uint32_t kSet = 0x50000508, kClear = 0x5000050C;
    register_at(high ? kSet : kClear) = 1U << number;
    return hal::Error::none;
  }
  static void make_output() {
    constexpr std::uint32_t kSetDirectionOut = 0x50000518;
    register_at(kSetDirectionOut) = 1U << number;
  }
};

// The panel's wires, with the pads of the edge connector.
using PanelClock = Pin<23>;        // 13, SCK
using PanelData = Pin<21>;         // 15, MOSI
using PanelDataCommand = Pin<16>;  // 16
using PanelSelect = Pin<18>;       // 8
using PanelReset = Pin<20>;        // 12

inline void start_panel_pins() {
  PanelClock::make_output();
  PanelData::make_output();
  PanelDataCommand::make_output();
  PanelSelect::make_output();
  PanelReset::make_output();
}

}  // namespace zstrip::board
