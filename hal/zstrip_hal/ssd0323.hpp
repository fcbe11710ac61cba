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

namespace zstrip::hal {

/// How a panel is wired to the controller, and how it is driven. The defaults suit OSRAM Pictiva panels of 128x64.
struct Ssd0323Config {
  std::uint8_t contrast = 0x3A;        ///< 0..127
  std::uint8_t display_offset = 0x4C;  ///< 0..79: the COM line that shows the first row
  /// Bits: 0 columns mirrored, 1 the high nibble is the left pixel (always set by the driver), 2 downwards first (never
  /// set by it), 4 rows mirrored, 6 COM lines split in odd and even.
  std::uint8_t remap = 0x52;
  bool dc_dc_converter = true;  ///< the panel's supply comes from the controller's converter
};

template <CommandDataBus Bus>
class Ssd0323 {
 public:
  static constexpr std::uint16_t kWidth = 128;
  static constexpr std::uint16_t kHeight = 64;

  /// `bus` must outlive the display.
  explicit constexpr Ssd0323(Bus& bus, const Ssd0323Config& config = {}) : bus_(bus), config_(config) {}

  /// Sets the controller up, blackens its memory and switches the panel on. To be called once, after the reset line
  /// went high (at least 3 us low before); takes 4.3 KB of bus traffic.
  Error start() {
    if (const Error error = command(start_sequence(config_)); error != Error::none) return error;
    if (const Error error = blacken(); error != Error::none) return error;
    return command(std::array{kDisplayOn});
  }

  constexpr std::uint16_t width() const { return kWidth; }
  constexpr std::uint16_t height() const { return kHeight; }
  constexpr PixelFormat format() const { return PixelFormat::gray4; }

  Error begin_frame() { return Error::none; }

  /// Left and width must be even: the controller's memory has two pixels a byte.
  Error write(const Area& area, std::span<const std::byte> pixels) {
    if (!contains(kWidth, kHeight, area)) return Error::area;
    if (area.left % 2 != 0 || area.width % 2 != 0) return Error::alignment;
    const std::uint32_t bytes = bytes_per_row(area.width, PixelFormat::gray4) * area.height;
    if (pixels.size() < bytes) return Error::pixels_too_small;
    if (const Error error = set_window(area); error != Error::none) return error;
    return bus_.write_data(pixels.first(bytes));
  }

  Error wait() { return bus_.wait(); }
  Error end_frame() { return Error::none; }

 private:
  static constexpr std::byte kSetColumns{0x15};
  static constexpr std::byte kSetRows{0x75};
  static constexpr std::byte kDisplayOn{0xAF};
  static constexpr std::byte kLastColumn{kWidth / 2 - 1};
  static constexpr std::byte kLastRow{kHeight - 1};

  static constexpr auto start_sequence(const Ssd0323Config& config) {
    const std::byte remap{static_cast<std::uint8_t>((config.remap & ~0x04U) | 0x02U)};
    const auto byte = [](unsigned value) { return static_cast<std::byte>(value); };
    // clang-format off
    return std::array{
        byte(0xAE),                              // display off
        kSetColumns, byte(0), kLastColumn,       // two pixels a column
        kSetRows, byte(0), kLastRow,
        byte(0x81), byte(config.contrast),
        byte(0x86),                              // full current range
        byte(0xA0), remap,
        byte(0xA1), byte(0),                     // display start line
        byte(0xA2), byte(config.display_offset),
        byte(0xA4),                              // normal display: neither all on nor all off nor inverse
        byte(0xA8), kLastRow,                    // multiplex ratio - 1
        byte(0xB1), byte(0x22),                  // phase lengths: 2 clocks of reset, 2 of precharge
        byte(0xB2), byte(0x46),                  // row period: 70 clocks
        byte(0xB3), byte(0xF1),                  // fastest oscillator, divided by 2
        byte(0xBF), byte(0x0D),                  // VSL, the low level of segments
        byte(0xBE), byte(0x02),                  // VCOMH, the high level of COM lines
        byte(0xBC), byte(0x10),                  // precharge voltage
        byte(0xB8), byte(0x01), byte(0x11), byte(0x22), byte(0x32),  // pulse lengths of the grey levels, each as an
                    byte(0x43), byte(0x54), byte(0x65), byte(0x76),  // increase over the one below
        byte(0xAD), byte(config.dc_dc_converter ? 3U : 2U),  // master configuration: bit 0 is the DC-DC converter
    };
    // clang-format on
  }

  /// Commands come from the stack: write_command has taken them when it returns.
  template <std::size_t count>
  Error command(const std::array<std::byte, count>& bytes) {
    return bus_.write_command(bytes);
  }

  /// The window's edges are inclusive, columns count bytes; the next data byte goes to its upper left corner.
  Error set_window(const Area& area) {
    const auto byte = [](int value) { return static_cast<std::byte>(value); };
    return command(std::array{kSetColumns, byte(area.left / 2), byte((area.left + area.width) / 2 - 1), kSetRows,
                              byte(area.top), byte(area.top + area.height - 1)});
  }

  /// The memory holds noise after power-on.
  Error blacken() {
    if (const Error error = set_window({0, 0, kWidth, kHeight}); error != Error::none) return error;
    return send_zeros(bus_, kWidth / 2 * kHeight);
  }

  Bus& bus_;
  Ssd0323Config config_;
};

}  // namespace zstrip::hal
