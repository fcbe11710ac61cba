// A model of the SSD0323 with an OLED glass of 128x64 and 16 greys.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "panel/solomon_model.hpp"

namespace zstrip::sim {

struct Ssd0323Glass {
  bool columns_reversed = false;  ///< SEG 0 is at the right of the upright glass
  bool rows_reversed = true;      ///< the first COM line is at the bottom
  bool com_split = true;          ///< odd rows on one side of the glass, even ones on the other
  std::uint8_t display_offset = 0x4C;
};

class Ssd0323Model final : public SolomonModel {
 public:
  explicit Ssd0323Model(const Ssd0323Glass& glass = {});

  RgbImage seen() const override;
  std::string darkness() const override;
  std::optional<unsigned> brightness() const override { return contrast_ * 2; }
  Nanoseconds shortest_cycle() const override { return 250ns; }

 private:
  static constexpr unsigned kColumns = 64;  // of two pixels
  static constexpr unsigned kRows = 80;
  static constexpr unsigned kGlassRows = 64;

  void execute(std::uint8_t code, std::span<const std::uint8_t> parameters) override;
  void store(std::uint8_t byte, std::uint8_t last_command) override;
  void reset_registers() override;
  Nanoseconds shortest_reset() const override { return 3us; }

  Ssd0323Glass glass_;
  std::array<std::uint8_t, kColumns * kRows> memory_{};
  SolomonRange columns_, rows_;
  unsigned contrast_ = 0x40, remap_ = 0, start_line_ = 0, offset_ = 0, multiplex_ = 79;
  bool on_ = false, normal_ = true, supplied_ = false, grey_table_ = false;
};

}  // namespace zstrip::sim
