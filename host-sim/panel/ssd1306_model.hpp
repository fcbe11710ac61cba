// A model of the SSD1306 with a one-bit OLED glass.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "panel/solomon_model.hpp"

namespace zstrip::sim {

/// Column x of the upright glass is SEG column_offset + x, counted from SEG 127 down if reversed; COM 0 is at the top
/// unless reversed.
struct Ssd1306Glass {
  std::uint16_t width = 128;
  std::uint16_t height = 64;
  std::uint16_t column_offset = 0;
  bool columns_reversed = true;
  bool rows_reversed = true;
  bool com_alternating = true;
  bool charge_pump = true;  ///< the charge pump is the only supply
};

class Ssd1306Model final : public SolomonModel {
 public:
  /// `shortest_cycle` is the cycle of its bus: 100 ns SPI, 2500 ns I2C.
  explicit Ssd1306Model(const Ssd1306Glass& glass = {}, Nanoseconds shortest_cycle = 100ns);

  RgbImage seen() const override;
  std::string darkness() const override;
  std::optional<unsigned> brightness() const override { return contrast_; }
  Nanoseconds shortest_cycle() const override { return cycle_; }

 private:
  static constexpr unsigned kColumns = 128, kPages = 8;

  void execute(std::uint8_t code, std::span<const std::uint8_t> parameters) override;
  void store(std::uint8_t byte, std::uint8_t last_command) override;
  void reset_registers() override;
  Nanoseconds shortest_reset() const override { return 3us; }

  Ssd1306Glass glass_;
  Nanoseconds cycle_;
  std::array<std::uint8_t, kColumns * kPages> memory_{};
  SolomonRange columns_, pages_;
  enum class Addressing : std::uint8_t { horizontal, vertical, page } addressing_ = Addressing::page;
  bool on_ = false, inverse_ = false, all_on_ = false, pump_ = false, segment_remap_ = false, scan_reversed_ = false;
  bool scrolling_ = false;
  unsigned start_line_ = 0, offset_ = 0, multiplex_ = 63, com_pins_ = 0x12, contrast_ = 0x7F;
};

}  // namespace zstrip::sim
