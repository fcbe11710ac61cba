// An Arduino board for sketches of firmware/examples on this machine: pins and SPI lead to the model of a panel, ST7789
// of 240x240 pixels. The functions of Arduino.h and SPI.h use it.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "panel/dcs_model.hpp"

namespace zstrip::package {

class Board {
 public:
  static constexpr unsigned kDataCommand = 8, kReset = 9, kSelect = 10;

  Board();

  void set_output(unsigned pin) { outputs_ |= 1U << pin; }
  void set_pin(unsigned pin, bool high);
  void pass_time(sim::Nanoseconds time) { panel_.elapse(time); }
  unsigned long milliseconds() const;

  void begin_transaction(std::uint32_t hertz);
  void end_transaction();
  void send(std::span<const std::byte> bytes);
  /// The bytes go over when it is asked whether they have, as late as DMA may be.
  void start_sending(std::span<const std::byte> bytes);
  bool has_sent();

  void say(const char* text) { said_ += text; }

  /// What is wrong: of what the sketch did, of what it said, of what the panel shows; empty if nothing is.
  std::string fault() const;
  sim::RgbImage seen() const { return panel_.seen(); }

 private:
  bool level(unsigned pin) const { return (levels_ >> pin & 1U) != 0; }
  void complain(const char* what);

  sim::DcsModel panel_;
  std::uint32_t outputs_ = 0, levels_ = 0;
  std::uint32_t hertz_ = 0;
  bool in_transaction_ = false;
  std::span<const std::byte> sending_;
  std::vector<std::byte> as_given_;
  std::string fault_, said_;
};

Board& board();

}  // namespace zstrip::package
