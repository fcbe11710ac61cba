// Solomon Systech SSD1306: controller of one-bit OLED panels up to 128x64, on a command/data bus: SPI (up to 10 MHz) or
// I2C (up to 400 kHz, i2c.hpp). Commands, their parameters and their order follow the data sheet (command table,
// software configuration); a parameter is sent like a command.
//
// Its memory has bytes of eight rows ("pages"), lowest bit on top, so that pixels are converted on their way
// (piecewise.hpp).
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

/// The wiring of the glass, and the orientation of the picture on it. The defaults suit modules of 128x64; modules of
/// 128x32 need height 32 and com_alternating false.
struct Ssd1306Config {
  std::uint8_t width = 128;        ///< of the upright glass, 1..128
  std::uint8_t height = 64;        ///< of the upright glass, 16..64, a multiple of 8
  std::uint8_t column_offset = 0;  ///< of the glass in the memory's 128 columns, counted from their first one: 32 for
                                   ///< 64x48
  Orientation orientation{};       ///< of the picture on the glass
  bool columns_reversed = true;    ///< wired from the right to the left
  bool rows_reversed = true;       ///< wired from the bottom to the top
  bool com_alternating = true;     ///< odd rows on one side of the glass, even ones on the other
  bool charge_pump = true;         ///< the panel's supply comes from the controller; else from outside
  std::uint8_t brightness = 0xCF;  ///< contrast, 0..255
};

/// A display that shows pixels as soon as they are written. Areas begin and end at multiples of eight rows (sideways:
/// of eight columns), else Error::alignment; present() needs strips of a multiple of kRowStep rows. `bus` must outlive
/// it.
template <CommandDataBus Bus>
class Ssd1306 {
 public:
  static constexpr std::uint16_t kColumns = 128;  ///< of the controller
  static constexpr std::uint16_t kRows = 64;      ///< of the controller
  static constexpr std::uint16_t kRowStep = 8;    ///< rows of a strip are a multiple of this

  /// Sends nothing: start() does.
  explicit constexpr Ssd1306(Bus& bus, const Ssd1306Config& config = {}) : bus_(bus), config_(config) {}

  /// Sets the controller up, blackens the glass and switches it on. Call it after reset_panel() (output_pin.hpp); if
  /// it fails, reset the panel and call it again. Returns Error::configuration, and sends nothing, for a glass that
  /// the controller cannot drive.
  Error start() {
    if (!valid()) return Error::configuration;
    // clang-format off
    Error error = command(
        0xAE,                                         // display off
        0xD5, 0x80,                                   // middle oscillator, not divided
        0xA8, config_.height - 1,                     // multiplex ratio
        0xD3, 0x00,                                   // display offset
        0x40,                                         // start line
        0x8D, config_.charge_pump ? 0x14 : 0x10,
        0x20, is_sideways(config_.orientation) ? 1 : 0,  // addresses run down pages first, or along columns
        scan().columns_reversed ? 0xA1 : 0xA0,
        scan().rows_reversed ? 0xC8 : 0xC0,
        0xDA, config_.com_alternating ? 0x12 : 0x02,
        0x81, config_.brightness,
        0xD9, config_.charge_pump ? 0xF1 : 0x22,      // phase lengths: 1 clock of reset, 15 of precharge, or 2 and 2
        0xDB, 0x40,                                   // VCOMH
        0xA4,                                         // the memory, not all on
        0xA6,                                         // not inverse
        0x2E);                                        // no scrolling
    // clang-format on
    if (error == Error::none) error = set_window({0, 0, width(), height()});
    if (error == Error::none) error = send_zeros(bus_, config_.width * config_.height / 8U);
    if (error == Error::none) error = wake();
    return error;
  }

  /// @{
  /// See the concept Display.
  constexpr std::uint16_t width() const { return is_sideways(config_.orientation) ? config_.height : config_.width; }
  constexpr std::uint16_t height() const { return is_sideways(config_.orientation) ? config_.width : config_.height; }
  constexpr DisplayFormat format() const { return DisplayFormat::mono; }

  /// After an error the controller may still wait for parameters of an interrupted command: at most two.
  Error begin_frame() {
    if (!broken_) return Error::none;
    constexpr int kShowMemory = 0xA4;  // harmless as a parameter
    const Error error = command(kShowMemory, kShowMemory, 0x81, config_.brightness);
    if (error == Error::none) broken_ = false;
    return error;
  }

  Error write(const Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    const bool sideways = is_sideways(config_.orientation);
    if (sideways ? (area.left % 8 != 0 || area.width % 8 != 0) : (area.top % 8 != 0 || area.height % 8 != 0)) {
      return Error::alignment;
    }
    const std::uint32_t row_bytes = bytes_per_row(area.width, DisplayFormat::mono);
    if (pixels.size() < row_bytes * area.height) return Error::pixels_too_small;
    if (const Error error = set_window(area); error != Error::none) return error;
    return noted(sideways ? send_rows(pixels.first(row_bytes * area.height)) : send_pages(area, row_bytes, pixels));
  }
  Error wait() { return noted(bus_.wait()); }
  Error end_frame() { return Error::none; }
  /// @}

  /// Switches the panel off, so that it needs nearly no current. The memory keeps its pixels, and may be written.
  Error sleep() { return command(0xAE); }
  /// Shows the memory again.
  Error wake() { return command(0xAF); }
  /// Sets the contrast, 0..255. No transfer may be under way.
  Error set_brightness(std::uint8_t level) {
    config_.brightness = level;
    return command(0x81, level);
  }

 private:
  constexpr bool valid() const {
    return config_.width >= 1 && config_.column_offset + config_.width <= kColumns && config_.height >= 16 &&
           config_.height <= kRows && config_.height % 8 == 0;
  }
  constexpr Scan scan() const {
    Scan scan = scan_of(config_.orientation);
    scan.columns_reversed = scan.columns_reversed != config_.columns_reversed;
    scan.rows_reversed = scan.rows_reversed != config_.rows_reversed;
    return scan;
  }

  Error noted(Error error) {
    if (error != Error::none) broken_ = true;
    return error;
  }
  template <class... Values>
  Error command(Values... values) {
    return noted(bus_.write_command(std::array{static_cast<std::byte>(values)...}));
  }

  /// Columns and pages are the glass's; edges are inclusive. The next data goes to the area's upper left corner.
  Error set_window(const Area& area) {
    const bool sideways = is_sideways(config_.orientation);
    const unsigned first = sideways ? area.top : area.left, count = sideways ? area.height : area.width;
    const unsigned row = sideways ? area.left : area.top, rows = sideways ? area.width : area.height;
    // The offset is counted from the end at which the columns begin, in the picture's direction.
    const unsigned from_other_end = kColumns - unsigned{config_.width} - config_.column_offset;
    const unsigned offset =
        scan_of(config_.orientation).columns_reversed ? from_other_end : unsigned{config_.column_offset};
    return command(0x21, offset + first, offset + first + count - 1, 0x22, row / 8, (row + rows) / 8 - 1);
  }

  /// Upright: a byte is a column of eight pixels.
  Error send_pages(const Area& area, std::uint32_t row_bytes, std::span<const std::byte> pixels) {
    for (std::uint32_t y = 0; y < area.height; y += 8) {
      const std::span<const std::byte> page = pixels.subspan(y * row_bytes, 8 * row_bytes);
      const Error error = pieces_.send(bus_, area.width, [page, row_bytes](std::uint32_t x) {
        const std::uint32_t shift = 7 - x % 8;
        std::uint32_t column = 0;
        for (std::uint32_t row = 8; row-- != 0;) {
          column = (column << 1) | ((std::to_integer<std::uint32_t>(page[row * row_bytes + x / 8]) >> shift) & 1U);
        }
        return column;
      });
      if (error != Error::none) return error;
    }
    return Error::none;
  }
  /// Sideways: a byte is eight pixels of a row, in the other order.
  Error send_rows(std::span<const std::byte> pixels) {
    return pieces_.send(bus_, static_cast<std::uint32_t>(pixels.size()), [pixels](std::uint32_t i) {
      std::uint32_t bits = std::to_integer<std::uint32_t>(pixels[i]);
      bits = ((bits & 0x55U) << 1) | ((bits >> 1) & 0x55U);
      bits = ((bits & 0x33U) << 2) | ((bits >> 2) & 0x33U);
      return ((bits & 0x0FU) << 4) | (bits >> 4);
    });
  }

  Bus& bus_;
  Ssd1306Config config_;
  bool broken_ = false;
  Piecewise pieces_{};
};

}  // namespace zstrip::hal
