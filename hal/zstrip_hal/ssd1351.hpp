// Solomon Systech SSD1351: controller of colour OLED panels of 128x128 or fewer rows, on a command/data bus. Serial
// clock up to 20 MHz (50 ns a cycle). Commands, their parameters and their order follow the data sheet (command table,
// power-on sequence); parameters are data. Its 18-bit format has the bits at the other end of each byte than other
// controllers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/blacken.hpp"
#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/orientation.hpp"
#include "zstrip_hal/parameters.hpp"

namespace zstrip::hal {

/// The wiring of the glass, and the orientation of the picture on it. The defaults suit the usual modules of 128x128.
struct Ssd1351Config {
  std::uint16_t height = 128;     ///< rows of the upright glass, 16..128; it has 128 columns
  Orientation orientation{};      ///< of the picture on the glass
  bool columns_reversed = false;  ///< wired from the right to the left
  bool rows_reversed = true;      ///< wired from the bottom to the top
  bool bgr = true;                ///< subpixels in the order C, B, A
  std::uint8_t brightness = 255;  ///< 0 dark .. 255, in steps of 16
};

/// A display that shows pixels as soon as they are written; any rectangle may be written. `bus` must outlive it.
template <CommandDataBus Bus>
class Ssd1351 {
 public:
  static constexpr std::uint16_t kColumns = 128;  ///< columns of the controller's memory
  static constexpr std::uint16_t kRows = 128;     ///< rows of the controller's memory

  /// Sends nothing: start() does.
  explicit constexpr Ssd1351(Bus& bus, const Ssd1351Config& config = {}) : bus_(bus), config_(config) {}

  /// Sets the controller up, blackens the glass and switches it on. Call it after reset_panel() (output_pin.hpp). May
  /// be repeated. The glass is lit 200 ms later. Returns Error::configuration, and sends nothing, if the height is out
  /// of range.
  Error start() {
    if (config_.height < 16 || config_.height > kRows) return Error::configuration;
    Error error = send_commands(bus_, kSettings);
    if (error == Error::none) error = send_command(bus_, std::byte{0xCA}, config_.height - 1);  // multiplex ratio
    if (error == Error::none) error = send_command(bus_, std::byte{0xA0}, remap());
    if (error == Error::none) error = set_brightness(config_.brightness);
    if (error == Error::none) error = set_window({0, 0, width(), height()});
    if (error == Error::none) error = send_zeros(bus_, bytes_per_row(width(), format()) * height());
    if (error == Error::none) error = wake();
    return error;
  }

  /// @{
  /// See the concept Display.
  constexpr std::uint16_t width() const { return is_sideways(config_.orientation) ? config_.height : kColumns; }
  constexpr std::uint16_t height() const { return is_sideways(config_.orientation) ? kColumns : config_.height; }
  constexpr DisplayFormat format() const { return DisplayFormat::rgb565_swapped; }

  Error begin_frame() { return Error::none; }
  Error write(const Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    const std::uint32_t bytes = bytes_per_row(area.width, format()) * area.height;
    if (pixels.size() < bytes) return Error::pixels_too_small;
    if (const Error error = set_window(area); error != Error::none) return error;
    return bus_.write_data(pixels.first(bytes));
  }
  Error wait() { return bus_.wait(); }
  Error end_frame() { return Error::none; }
  /// @}

  /// Switches the panel off, so that it needs nearly no current. The memory keeps its pixels, and may be written.
  Error sleep() { return send_command(bus_, std::byte{0xAE}); }
  /// Shows the memory again.
  Error wake() { return send_command(bus_, std::byte{0xAF}); }
  /// Sets the master current: 0..255, in steps of 16. No transfer may be under way.
  Error set_brightness(std::uint8_t level) { return send_command(bus_, std::byte{0xC7}, level >> 4); }

 private:
  // clang-format off
  static constexpr auto kSettings = bytes(
      0xFD, 1, 0x12,              // unlock
      0xFD, 1, 0xB1,              // unlock A2, B1, B3, BB, BE, C1 too
      0xAE, 0,                    // sleep
      0xB3, 1, 0xF1,              // fastest oscillator, divided by 2
      0xA1, 1, 0x00,              // start line
      0xA2, 1, 0x00,              // offset
      0xB5, 1, 0x00,              // GPIO off
      0xAB, 1, 0x01,              // internal VDD
      0xB1, 1, 0x32,              // phase lengths: 5 clocks of reset, 3 of precharge
      0xB4, 3, 0xA0, 0xB5, 0x55,  // VSL external
      0xB6, 1, 0x01,              // second precharge
      0xBB, 1, 0x17,              // precharge voltage
      0xBE, 1, 0x05,              // VCOMH
      0xC1, 3, 0xC8, 0x80, 0xC8,  // contrast of A, B, C
      0xB9, 0,                    // greys in equal steps
      0xA6, 0);                   // normal: the memory, not inverted
  // clang-format on
  static_assert(is_command_list(kSettings));

  constexpr unsigned remap() const {
    constexpr unsigned kDownwardsFirst = 0x01, kColumnsReversed = 0x02, kSequenceCBA = 0x04, kRowsReversed = 0x10;
    constexpr unsigned kSplitOddEven = 0x20, k65536Colours = 0x40;
    const Scan scan = scan_of(config_.orientation);
    return k65536Colours | kSplitOddEven | (config_.bgr ? kSequenceCBA : 0U) | (scan.exchanged ? kDownwardsFirst : 0U) |
           (scan.columns_reversed != config_.columns_reversed ? kColumnsReversed : 0U) |
           (scan.rows_reversed != config_.rows_reversed ? kRowsReversed : 0U);
  }

  /// Columns and rows are those of the glass; edges are inclusive. The next data goes to the area's upper left corner.
  Error set_window(const Area& area) {
    const bool sideways = is_sideways(config_.orientation);
    const unsigned right = area.left + area.width - 1U, bottom = area.top + area.height - 1U;
    const std::byte across{0x15}, down{0x75};
    Error error = send_command(bus_, sideways ? down : across, area.left, right);
    if (error == Error::none) error = send_command(bus_, sideways ? across : down, area.top, bottom);
    if (error == Error::none) error = send_command(bus_, std::byte{0x5C});  // write to memory
    return error;
  }

  Bus& bus_;
  Ssd1351Config config_;
};

}  // namespace zstrip::hal
