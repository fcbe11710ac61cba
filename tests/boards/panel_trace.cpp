// Parses traced writes and follows the levels of the lines.
#include "panel_trace.hpp"

#include <charconv>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace zstrip::boards {
namespace {

/// Hexadecimal, with "0x" before it.
std::optional<std::uint64_t> number_after(std::string_view line, std::string_view word) {
  const std::size_t at = line.find(word);
  if (at == std::string_view::npos) return std::nullopt;
  line.remove_prefix(at + word.size());
  if (line.starts_with("0x")) line.remove_prefix(2);
  std::uint64_t value = 0;
  const std::from_chars_result read = std::from_chars(line.data(), line.data() + line.size(), value, 16);
  return read.ec == std::errc{} ? std::optional(value) : std::nullopt;
}

/// Where both are asked for, set wins (RM0090, 8.4.7).
template <class Set>
void follow(const StmPin& pin, const RegisterWrite& write, Set&& set) {
  if (write.address != pin.set_reset) return;
  if ((write.value >> pin.bit & 1U) != 0) {
    set(true);
  } else if ((write.value >> (pin.bit + 16) & 1U) != 0) {
    set(false);
  }
}

constexpr std::uint8_t kColumns = 0x2A, kRows = 0x2B, kMemoryWrite = 0x2C;

}  // namespace

std::optional<RegisterWrite> parse_write(const std::string& line) {
  const bool pins = line.starts_with("nrf51_gpio_write ");
  if (!pins && !line.starts_with("memory_region_ops_write ")) return std::nullopt;
  const auto address = number_after(line, pins ? " offset " : " addr "), value = number_after(line, " value ");
  if (!address || !value) return std::nullopt;
  return RegisterWrite{*address, *value};
}

void PanelWires::set_select(bool high) {
  if (selected_ == !high) return;
  if (bits_ != 0) panel_.driver_broke("deselected amid a byte");
  selected_ = !high;
  bits_ = 0;
}

void PanelWires::set_reset(bool high) {
  panel_.elapse(std::chrono::seconds(1));
  panel_.set_reset(high);
}

void PanelWires::set_clock(bool high) {
  const bool rises = high && !clock_;
  clock_ = high;
  if (!rises || !selected_) return;
  shift_ = (shift_ << 1 | (data_line_ ? 1U : 0U)) & 0xFFU;
  if (++bits_ < 8) return;
  bits_ = 0;
  shift_byte(static_cast<std::uint8_t>(shift_));
}

void PanelWires::shift_byte(std::uint8_t byte) {
  if (!selected_) return;
  if (!data_) {
    panel_.elapse(std::chrono::seconds(1));
    command_ = {byte};
    if (byte == kMemoryWrite) windows_.push_back({columns_[0], columns_[1], rows_[0], rows_[1], 0});
  } else if (!command_.empty() && command_.front() == kMemoryWrite) {
    ++windows_.back().bytes;
  } else {
    command_.push_back(byte);
    const auto pair = [&](std::size_t at) { return static_cast<unsigned>(command_[at] << 8 | command_[at + 1]); };
    if (command_.size() == 5 && command_.front() == kColumns) columns_ = {pair(1), pair(3)};
    if (command_.size() == 5 && command_.front() == kRows) rows_ = {pair(1), pair(3)};
  }
  const std::array<std::byte, 1> bytes{static_cast<std::byte>(byte)};
  panel_.receive(data_ ? sim::Wire::data : sim::Wire::command, bytes);
}

void PanelWires::missed_some() {
  panel_.interrupted();
  selected_ = false;
  bits_ = 0;
}

void feed(PanelWires& wires, const BitBangedPins& pins, const RegisterWrite& write) {
  constexpr std::uint64_t kSet = 0x508, kClear = 0x50C;
  if (write.address != kSet && write.address != kClear) return;
  const bool high = write.address == kSet;
  const auto touched = [&](std::uint32_t mask) { return (write.value & mask) != 0; };
  if (touched(pins.reset)) wires.set_reset(high);
  if (touched(pins.data_command)) wires.set_data_command(high);
  if (touched(pins.select)) wires.set_select(high);
  if (touched(pins.data)) wires.set_data(high);
  if (touched(pins.clock)) wires.set_clock(high);
}

void feed(PanelWires& wires, const StmSpiPins& pins, const RegisterWrite& write) {
  if (write.address == pins.spi_data) return wires.shift_byte(static_cast<std::uint8_t>(write.value));
  follow(pins.reset, write, [&](bool high) { wires.set_reset(high); });
  follow(pins.data_command, write, [&](bool high) { wires.set_data_command(high); });
  follow(pins.select, write, [&](bool high) { wires.set_select(high); });
}

void feed(PanelWires& wires, const StmBitBangedPins& pins, const RegisterWrite& write) {
  follow(pins.reset, write, [&](bool high) { wires.set_reset(high); });
  follow(pins.data_command, write, [&](bool high) { wires.set_data_command(high); });
  follow(pins.select, write, [&](bool high) { wires.set_select(high); });
  follow(pins.data, write, [&](bool high) { wires.set_data(high); });
  follow(pins.clock, write, [&](bool high) { wires.set_clock(high); });
}

}  // namespace zstrip::boards
