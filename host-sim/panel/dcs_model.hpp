// A model of the panels whose controller follows MIPI's Display Command Set (dcs_part.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "panel/dcs_part.hpp"
#include "panel/panel_model.hpp"

namespace zstrip::sim {

/// The wiring between glass and controller. Pixel (x, y) of the upright glass is cell (column_offset + x, row_offset +
/// y) of the memory, counted from the other end if reversed.
struct Glass {
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  std::uint16_t column_offset = 0;
  std::uint16_t row_offset = 0;
  bool columns_reversed = false;
  bool rows_reversed = false;
  bool bgr = false;       ///< subpixels are blue, green, red
  bool inverted = false;  ///< more voltage is darker, so that inversion must be on
  bool is_round = false;  ///< only the largest circle is there
};

class DcsModel final : public PanelModel {
 public:
  DcsModel(const DcsPart& part, const Glass& glass);

  void interrupted() override;
  RgbImage seen() const override;
  std::string darkness() const override;
  std::optional<unsigned> brightness() const override;
  Nanoseconds shortest_cycle() const override { return part_.shortest_cycle; }
  Nanoseconds shortest_read_cycle() const override { return part_.shortest_read_cycle; }

 private:
  using Colour = std::array<std::uint8_t, 3>;  // red, green, blue of 6 bits
  struct Range {
    unsigned first = 0, last = 0;
  };

  void receive_byte(Wire wire, std::uint8_t byte) override;
  void execute_phases(std::span<const std::byte> header, std::span<const std::byte> data, unsigned lines) override;
  void take(Wire wire, std::uint8_t byte);
  std::vector<bool> answer(std::uint8_t code) override;
  void reset() override;
  Nanoseconds shortest_reset() const override { return part_.shortest_reset; }

  void begin(std::uint8_t code);
  void check_time(std::uint8_t code);
  void finish_command();
  void parameters_complete();
  void turn_key();
  void receive_pixel_byte(std::uint8_t byte);
  void store(const Colour& colour);
  Range range_of(unsigned limit, const char* what);
  unsigned bits_per_pixel() const;
  std::size_t cell(unsigned column, unsigned row) const;
  bool is_on_disc(unsigned x, unsigned y) const;
  void complain_of(const char* what);

  const DcsPart& part_;
  Glass glass_;
  std::vector<Colour> memory_;

  // Registers.
  bool asleep_ = true, on_ = false, inverted_ = false, idle_ = false, partial_ = false;
  std::uint8_t access_ = 0, format_ = 0;
  std::uint8_t brightness_ = 0, brightness_control_ = 0;
  unsigned scroll_ = 0;
  unsigned read_index_ = 0;     // 0: not set
  std::size_t keys_given_ = 0;  // of the part's, in their order
  Range columns_, rows_;

  // The current command.
  const DcsCommand* command_ = nullptr;
  std::uint8_t code_ = 0;
  std::vector<std::uint8_t> parameters_;
  bool excused_ = false;
  bool writing_ = false, wrote_ = false;
  unsigned column_ = 0, row_ = 0;
  bool full_ = false;
  std::uint32_t bits_ = 0;
  unsigned bit_count_ = 0;

  // Earliest times of these commands.
  Nanoseconds next_command_{}, next_sleep_out_{}, next_sleep_in_{};
};

}  // namespace zstrip::sim
