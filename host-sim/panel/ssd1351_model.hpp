// A model of the SSD1351 with a colour OLED glass of 128 columns.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "panel/solomon_model.hpp"

namespace zstrip::sim {

/// SEG 0 is at the left of the upright glass unless reversed, COM 0 at its top.
struct Ssd1351Glass {
  std::uint16_t height = 128;
  bool columns_reversed = false;
  bool rows_reversed = true;
  bool bgr = true;  ///< the subpixels from left to right are the driver's C, B, A
};

class Ssd1351Model final : public SolomonModel {
 public:
  explicit Ssd1351Model(const Ssd1351Glass& glass = {});

  RgbImage seen() const override;
  std::string darkness() const override;
  std::optional<unsigned> brightness() const override { return master_ * 17; }
  Nanoseconds shortest_cycle() const override { return 50ns; }

 private:
  static constexpr unsigned kSide = 128;

  void execute(std::uint8_t code, std::span<const std::uint8_t> parameters) override;
  void store(std::uint8_t byte, std::uint8_t last_command) override;
  void reset_registers() override;
  Nanoseconds shortest_reset() const override { return 2us; }
  void end_of_pixels();

  Ssd1351Glass glass_;
  std::vector<std::uint16_t> memory_;  // RGB565
  SolomonRange columns_, rows_;
  bool on_ = false, unlocked_ = true, second_unlocked_ = false, inverse_ = false, showing_memory_ = true;
  std::uint8_t remap_ = 0, start_line_ = 0, offset_ = 0, multiplex_ = 127;
  unsigned master_ = 15;
  int held_ = -1;  // the first byte of a pixel
  bool full_ = false;
};

}  // namespace zstrip::sim
