// Solomon Systech SSD0323: controller of OLED panels of 128x64 pixels with 16 greys, on a command/data bus.
// Commands, their parameters and their order follow the data sheet (command table, power-on sequence). A parameter is
// sent like a command, with D/C low. The serial clock may have at most 4 MHz; data is taken at its rising edge.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/blacken.hpp"
#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/orientation.hpp"
#include "zstrip_hal/piecewise.hpp"

namespace zstrip::hal {

/// The wiring of a panel to the controller, and its supply. The defaults suit OSRAM Pictiva panels of 128x64.
struct Ssd0323Config {
  std::uint8_t contrast = 0x3A;        ///< 0..127
  std::uint8_t display_offset = 0x4C;  ///< 0..79: the COM line of the first row, in the direction of the scan
  Orientation orientation{};           ///< of the picture on the glass
  bool columns_reversed = false;       ///< the glass is wired from the right to the left
  bool rows_reversed = true;           ///< the glass is wired from the bottom to the top
  bool com_split = true;               ///< odd rows on one side of the glass, even ones on the other
  bool dc_dc_converter = true;         ///< the panel's supply comes from the controller's converter
};

/// A display that shows pixels as soon as they are written. Its memory has two pixels a byte, next to each other on
/// the upright glass: left and width of an area must be even (sideways: top and height), else Error::alignment. `bus`
/// must outlive it.
template <CommandDataBus Bus>
class Ssd0323 {
 public:
  static constexpr std::uint16_t kWidth = 128;  ///< of the upright glass
  static constexpr std::uint16_t kHeight = 64;  ///< of the upright glass
  static constexpr std::uint16_t kRowStep =
      2;  ///< rows of a strip are a multiple of this, where the picture is sideways

  /// Sends nothing: start() does.
  explicit constexpr Ssd0323(Bus& bus, const Ssd0323Config& config = {}) : bus_(bus), config_(config) {}

  /// Sets the controller up, blackens its memory and switches the panel on. Call it once, after the reset line went
  /// high (at least 3 us low before). If it fails, reset the panel and call it again. Sends 4.3 KB over the bus.
  Error start() {
    if (const Error error = command(start_sequence()); error != Error::none) return error;
    if (const Error error = set_window({0, 0, width(), height()}); error != Error::none) return error;
    if (const Error error = send_zeros(bus_, kWidth / 2 * kHeight); error != Error::none) return error;
    return wake();
  }

  /// @{
  /// See the concept Display.
  constexpr std::uint16_t width() const { return is_sideways(config_.orientation) ? kHeight : kWidth; }
  constexpr std::uint16_t height() const { return is_sideways(config_.orientation) ? kWidth : kHeight; }
  constexpr DisplayFormat format() const { return DisplayFormat::gray4; }

  /// After an error the controller may still wait for parameters of an interrupted command: at most two.
  Error begin_frame() {
    if (!broken_) return Error::none;
    const Error error = command(std::array{kShowMemory, kShowMemory, kContrast, std::byte{config_.contrast}});
    if (error == Error::none) broken_ = false;
    return error;
  }

  Error write(const Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    const bool sideways = is_sideways(config_.orientation);
    if (sideways ? (area.top % 2 != 0 || area.height % 2 != 0) : (area.left % 2 != 0 || area.width % 2 != 0)) {
      return Error::alignment;
    }
    const std::uint32_t row_bytes = bytes_per_row(area.width, DisplayFormat::gray4);
    if (pixels.size() < row_bytes * area.height) return Error::pixels_too_small;
    if (const Error error = set_window(area); error != Error::none) return error;
    if (sideways) return noted(send_columns(area, row_bytes, pixels));
    return noted(bus_.write_data(pixels.first(row_bytes * area.height)));
  }

  Error wait() { return noted(bus_.wait()); }
  Error end_frame() { return Error::none; }
  /// @}

  /// Switches the panel off, so that it needs nearly no current. The memory keeps its pixels, and may be written.
  Error sleep() { return command(std::array{std::byte{0xAE}}); }
  /// Shows the memory again.
  Error wake() { return command(std::array{std::byte{0xAF}}); }
  /// Sets the contrast: 0..255, in steps of two. No transfer may be under way.
  Error set_brightness(std::uint8_t level) {
    config_.contrast = level / 2;
    return command(std::array{kContrast, std::byte{config_.contrast}});
  }

 private:
  static constexpr std::byte kSetColumns{0x15};
  static constexpr std::byte kSetRows{0x75};
  static constexpr std::byte kContrast{0x81};
  static constexpr std::byte kShowMemory{0xA4};  // shows the memory, not all on, all off or inverted; harmless as a
                                                 // parameter
  static constexpr std::byte kLastColumn{kWidth / 2 - 1};
  static constexpr std::byte kLastRow{kHeight - 1};

  /// Bits: 0 columns from the right, 1 the high nibble is the left pixel of the glass, 2 downwards first, 4 rows from
  /// the bottom, 6 COM lines split in odd and even.
  constexpr unsigned remap() const {
    const Scan scan = scan_of(config_.orientation);
    const bool from_the_right = scan.columns_reversed != config_.columns_reversed;
    // The high nibble is the first pixel in the direction of the columns.
    return (from_the_right ? 0x01U : 0x02U) | (scan.exchanged ? 0x04U : 0U) |
           (scan.rows_reversed != config_.rows_reversed ? 0x10U : 0U) | (config_.com_split ? 0x40U : 0U);
  }

  constexpr auto start_sequence() const {
    const auto byte = [](unsigned value) { return static_cast<std::byte>(value); };
    // clang-format off
    return std::array{
        byte(0xAE),                              // display off
        kSetColumns, byte(0), kLastColumn,       // two pixels a column
        kSetRows, byte(0), kLastRow,
        kContrast, byte(config_.contrast),
        byte(0x86),                              // full current range
        byte(0xA0), byte(remap()),
        byte(0xA1), byte(0),                     // display start line
        byte(0xA2), byte(config_.display_offset),
        kShowMemory,
        byte(0xA8), kLastRow,                    // multiplex ratio - 1
        byte(0xB1), byte(0x22),                  // phase lengths: 2 clocks of reset, 2 of precharge
        byte(0xB2), byte(0x46),                  // row period: 70 clocks
        byte(0xB3), byte(0xF1),                  // fastest oscillator, divided by 2
        byte(0xBF), byte(0x0D),                  // VSL, the low level of segments
        byte(0xBE), byte(0x02),                  // VCOMH, the high level of COM lines
        byte(0xBC), byte(0x10),                  // precharge voltage
        byte(0xB8), byte(0x01), byte(0x11), byte(0x22), byte(0x32),  // pulse lengths of the grey levels, each as an
                    byte(0x43), byte(0x54), byte(0x65), byte(0x76),  // increase over the one below
        byte(0xAD), byte(config_.dc_dc_converter ? 3U : 2U),  // master configuration: bit 0 is the DC-DC converter
    };
    // clang-format on
  }

  Error noted(Error error) {
    if (error != Error::none) broken_ = true;
    return error;
  }
  /// Commands come from the stack: write_command has taken them when it returns.
  template <std::size_t count>
  Error command(const std::array<std::byte, count>& bytes) {
    return noted(bus_.write_command(bytes));
  }

  /// Columns (of two pixels) and rows are those of the glass; edges are inclusive. The next data byte goes to the
  /// area's upper left corner.
  Error set_window(const Area& area) {
    const bool sideways = is_sideways(config_.orientation);
    const int left = sideways ? area.top : area.left, columns = sideways ? area.height : area.width;
    const int top = sideways ? area.left : area.top, rows = sideways ? area.width : area.height;
    const auto byte = [](int value) { return static_cast<std::byte>(value); };
    return command(std::array{kSetColumns, byte(left / 2), byte((left + columns) / 2 - 1), kSetRows, byte(top),
                              byte(top + rows - 1)});
  }

  /// Sideways a byte holds a pixel of one row and the one below it.
  Error send_columns(const Area& area, std::uint32_t row_bytes, std::span<const std::byte> pixels) {
    for (std::uint32_t y = 0; y < area.height; y += 2) {
      const std::span<const std::byte> pair = pixels.subspan(y * row_bytes, 2 * row_bytes);
      const Error error = pieces_.send(bus_, area.width, [pair, row_bytes](std::uint32_t x) {
        const std::uint32_t shift = x % 2 == 0 ? 4 : 0;
        const auto level = [pair, shift](std::uint32_t at) {
          return (std::to_integer<std::uint32_t>(pair[at]) >> shift) & 0xFU;
        };
        return level(x / 2) << 4 | level(row_bytes + x / 2);
      });
      if (error != Error::none) return error;
    }
    return Error::none;
  }

  Bus& bus_;
  Ssd0323Config config_;
  bool broken_ = false;
  Piecewise pieces_{};
};

}  // namespace zstrip::hal
