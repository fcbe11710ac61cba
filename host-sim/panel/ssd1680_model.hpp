// A model of the SSD1680 with a glass of black and white e-paper.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "panel/solomon_model.hpp"

namespace zstrip::sim {

struct Ssd1680Glass {
  std::uint16_t width = 128;
  std::uint16_t height = 296;
  std::uint16_t column_offset = 0;  ///< columns of the memory left of the glass, a multiple of 8
  bool sources_from_8 = true;       ///< wired to S8 to S167
  bool swaps_memories = false;      ///< its waveform exchanges the two memories at each partial refresh ("ping-pong")
};

/// Refreshes take the time of a 2.13" module at room temperature. A partial refresh moves the pixels that differ from
/// the second memory; all others keep what the glass shows.
class Ssd1680Model final : public SolomonModel {
 public:
  explicit Ssd1680Model(const Ssd1680Glass& glass = {});

  RgbImage seen() const override;
  std::string darkness() const override;
  Nanoseconds shortest_cycle() const override { return 50ns; }
  Nanoseconds refreshing() const override { return refreshing_; }

  /// Returns the level of the BUSY line.
  bool is_busy() const { return asleep_ || now() < ready_at_; }
  int full_refreshes() const { return full_refreshes_; }
  int partial_refreshes() const { return partial_refreshes_; }

 private:
  static constexpr unsigned kColumnBytes = 22, kRows = 296;
  using Memory = std::vector<std::uint8_t>;  // rows of bytes; 1 is white

  void execute(std::uint8_t code, std::span<const std::uint8_t> parameters) override;
  void store(std::uint8_t byte, std::uint8_t last_command) override;
  void reset_registers() override;
  Nanoseconds shortest_reset() const override { return 10us; }
  bool is_refused(std::uint8_t code);
  void set_windows(std::uint8_t code, std::span<const std::uint8_t> parameters);
  void begin_write();
  void activate();
  void refresh(bool partial);
  void be_busy(Nanoseconds time);

  Ssd1680Glass glass_;
  Memory shown_, picture_, previous_;

  // Registers.
  unsigned lines_ = 0;  // of the driver output
  unsigned entry_ = 0, sequence_ = 0, temperature_sensor_ = 0;
  std::uint8_t sources_ = 0;
  SolomonRange columns_, rows_;  // columns of 8 pixels
  bool clock_on_ = false, supply_on_ = false, has_waveform_ = false, asleep_ = false, full_ = false;

  Nanoseconds ready_at_{}, refreshing_{};
  int full_refreshes_ = 0, partial_refreshes_ = 0;
  std::string fault_ = "the panel was never refreshed";  // of the last refresh
};

}  // namespace zstrip::sim
