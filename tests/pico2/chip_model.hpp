// An RP2350 as far as the Pico 2's program uses it: what the chip would not take is a complaint, which ends the
// program. Written from the makers' register headers and its data sheet (docs/hardware-review.md), with numbers of its
// own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <span>
#include <stdexcept>
#include <string>

#include "panel/dcs_model.hpp"

namespace zstrip::pico2 {

struct ResetBlock;

/// Thrown at the program.
struct Complaint : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Chip {
 public:
  /// What arrives in place of a write; false: nothing does. And what is read in place of a value.
  struct Mutation {
    std::function<bool(std::uint32_t& address, std::uint32_t& value)> write;
    std::function<void(std::uint32_t address, std::uint32_t& value)> read;
  };

  explicit Chip(Mutation mutation = {});

  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);
  void pass(sim::Nanoseconds time);

  /// The DMA reads there, and in this program's image. It has addresses of 32 bits.
  void has_ram(std::uintptr_t begin, std::size_t size) { ram_ = {begin, begin + size}; }
  /// Bytes do not leave the SPI until it is switched off.
  void stick() { stuck_ = true; }
  /// When the watchdog resets the chip; in the past: it has.
  sim::Nanoseconds watchdog_time() const;
  sim::Nanoseconds now() const { return now_; }
  std::uint32_t system_hertz() const;
  const std::string& console() const { return console_; }
  sim::DcsModel& panel() { return panel_; }
  bool is_lit() const { return levels_[3] == 1; }

 private:
  static constexpr int kFloating = 2;

  std::uint32_t& at(std::uint32_t address);
  std::uint32_t stored(std::uint32_t address) const;
  bool has_peripheral_clock() const;
  bool is_ready(const ResetBlock& block) const;
  void check_reset(std::uint32_t address) const;
  std::uint32_t answer(std::uint32_t address);
  std::uint32_t pll_hertz() const;
  std::uint32_t reference_hertz() const;
  void check_pin(unsigned pin, std::uint32_t function) const;
  void update_lines();
  void before_write(std::uint32_t address, std::uint32_t old, std::uint32_t value);
  void after_write(std::uint32_t address, std::uint32_t old, std::uint32_t value);
  void write_clocks(std::uint32_t address, std::uint32_t old, std::uint32_t value);
  void write_pll();
  void write_spi(std::uint32_t address, std::uint32_t value);
  void write_dma(std::uint32_t address, std::uint32_t value);
  std::uint64_t timer_ticks() const;
  void write_watchdog(std::uint32_t address, std::uint32_t old, std::uint32_t value);
  void send_character(std::uint32_t value);
  void move_bytes();
  void deliver(std::uint8_t byte);
  bool is_sending() const { return !sending_.empty(); }
  [[noreturn]] void complain(const std::string& what) const;

  Mutation mutation_;
  std::array<std::uintptr_t, 2> ram_{};  // from, up to
  std::map<std::uint32_t, std::uint32_t> registers_;
  std::map<std::uint32_t, sim::Nanoseconds> released_;  // by bit of RESETS
  sim::Nanoseconds now_{0}, crystal_stable_{sim::Nanoseconds::max()}, pll_locked_{sim::Nanoseconds::max()};
  sim::Nanoseconds console_idle_{0}, byte_done_{0}, watchdog_loaded_{0}, timer_started_{0};
  std::uint32_t last_read_ = 0, reads_ = 0;
  std::string console_;
  std::deque<std::uint8_t> sending_;
  std::size_t received_ = 0;  // by the SPI, which are not read
  const std::byte* source_ = nullptr;
  std::uint32_t left_ = 0;
  bool dma_busy_ = false, stuck_ = false;
  std::uint32_t outputs_ = 0, enabled_ = 0;                                // of the pins
  std::array<int, 4> levels_{kFloating, kFloating, kFloating, kFloating};  // select, D/C, reset, light
  sim::DcsModel panel_{sim::kSt7789Part, sim::Glass{.width = 240, .height = 240, .inverted = true}};
};

}  // namespace zstrip::pico2
