// The wires of a panel, decoded from what the emulator traces: every write of the program to pins and controllers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "panel/panel_model.hpp"

namespace zstrip::boards {

/// One traced write of the program to a register.
struct RegisterWrite {
  std::uint64_t address;
  std::uint64_t value;
};

/// From a line "nrf51_gpio_write offset 0x508 value 0x10" (the address is the offset), or "memory_region_ops_write cpu
/// 0 mr 0x55 addr 0x4001300c value 0x2a size 4 name 'x'"; nothing from any other line.
std::optional<RegisterWrite> parse_write(const std::string& line);

/// The lines of a panel on SPI mode 0 and what they mean to it. Between two commands as much time passes for the model
/// as any of them may take: what the emulator traces has no times.
class PanelWires {
 public:
  explicit PanelWires(sim::PanelModel& panel) : panel_(panel) {}

  void set_select(bool high);
  void set_data_command(bool high) { data_ = high; }
  void set_reset(bool high);
  /// For bits on lines: the panel takes the data line's level at the rising edge.
  void set_clock(bool high);
  void set_data(bool high) { data_line_ = high; }
  /// For controllers that shift by themselves.
  void shift_byte(std::uint8_t byte);

  /// Some writes were not traced; the panel is deselected again.
  void missed_some();

  /// A write of pixels: columns and rows, the last ones included.
  struct Window {
    unsigned left, right, top, bottom;
    std::uint64_t bytes;
  };
  const std::vector<Window>& windows() const { return windows_; }

 private:
  sim::PanelModel& panel_;
  bool selected_ = false, data_ = false, clock_ = false, data_line_ = false;
  unsigned bits_ = 0, shift_ = 0;
  std::vector<std::uint8_t> command_;  // and its parameters
  std::array<unsigned, 2> columns_{}, rows_{};
  std::vector<Window> windows_;
};

/// Pins of the micro:bit by their masks.
struct BitBangedPins {
  std::uint32_t clock, data, data_command, select, reset;
};
void feed(PanelWires& wires, const BitBangedPins& pins, const RegisterWrite& write);

/// An STM32's SPI, and the pins beside it: the address of a port's bit set/reset register, and the pin's bit.
struct StmPin {
  std::uint64_t set_reset;
  unsigned bit;
};
struct StmSpiPins {
  std::uint64_t spi_data;
  StmPin data_command, select, reset;
};
void feed(PanelWires& wires, const StmSpiPins& pins, const RegisterWrite& write);

}  // namespace zstrip::boards
