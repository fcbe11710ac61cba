// The common part of panels whose controller follows MIPI's Display Command Set, as the SPI controllers of Sitronix
// and Ilitek do. st7789.hpp, ili9341.hpp and st7735.hpp hold the parts that differ.
//
// A command is one byte with D/C low, its parameters follow with D/C high. A new command ends the one before it, even
// an incomplete one, so that after any error the next window starts clean.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "zstrip_hal/blacken.hpp"
#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/clock.hpp"
#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/orientation.hpp"
#include "zstrip_hal/parameters.hpp"
#include "zstrip_hal/widened.hpp"

namespace zstrip::hal {

/// The wiring of a glass to its controller, and the orientation of the picture on it. Sizes and offsets are those of
/// the upright glass, whatever the orientation.
struct DcsConfig {
  std::uint16_t width = 0;          ///< of the glass, 1 up to the controller's columns
  std::uint16_t height = 0;         ///< of the glass, 1 up to the controller's rows
  std::uint16_t column_offset = 0;  ///< position of the glass in the controller's memory, if the memory is larger
  std::uint16_t row_offset = 0;     ///< position of the glass in the controller's memory, if the memory is larger
  Orientation orientation{};        ///< of the picture on the glass
  DisplayFormat format = DisplayFormat::rgb565_swapped;  ///< or rgb666; or rgb444, if the controller supports it
  bool columns_reversed = false;                         ///< the glass is wired from the right to the left
  bool rows_reversed = false;                            ///< the glass is wired from the bottom to the top
  bool bgr = false;                                      ///< subpixels in the order blue, green, red
  bool inverted = false;                                 ///< the panel shows inverted colours, as most IPS panels do
  /// Commands that the module's data sheet requires (voltages, gamma), sent before the panel wakes up: the command, the
  /// number of its parameters, its parameters; then the next command. Must outlive the display.
  std::span<const std::byte> module_commands{};
  /// The id that the controller must answer in start(): three bytes, the highest first, such as kId of the controller's
  /// class; a module may answer with its maker's own id. Must be below 0xFFFFFF, the value that is read without an
  /// answer. With 0, the default, start() does not read the id, because many modules have no wire for answers.
  std::uint32_t id = 0;
};

/// Returns the configuration of `module` with the picture rotated clockwise on the glass.
constexpr DcsConfig turned(DcsConfig module, Rotation by) {
  module.orientation.rotation = by;
  return module;
}

/// The traits of a controller; the defaults are usual.
struct DcsTraits {
  bool widens_565 = false;    ///< its bus takes no pixels of 16 bits, so that rgb565_swapped is sent as rgb666
  bool even_areas = false;    ///< areas must begin and end at even columns and rows
  bool exchanges = true;      ///< rows and columns can be exchanged
  bool reverses_rows = true;  ///< rows can be counted from the bottom
  std::uint8_t brightness_control = 0x24;  ///< parameter of WRCTRLD, so that commands set the brightness
};

/// A driver of a controller defines these members:
///   - kColumns, kRows: size of its memory, with the glass upright
///   - pixel_format(format): the parameter of COLMOD, 0 for a format that the controller does not support
///   - kSettings: commands for every module, as DcsConfig::module_commands
///   - kHasBrightness: true if the controller has a PWM output for a backlight
///   - kId: the three bytes that read_id(bus, id) reads on a ReadableBus; 0 if it has no read_id
///   - kTraits, only if one of them is not usual
template <class T>
concept DcsController = requires(DisplayFormat format) {
  { T::kColumns } -> std::convertible_to<std::uint16_t>;
  { T::kRows } -> std::convertible_to<std::uint16_t>;
  { T::pixel_format(format) } -> std::same_as<std::uint8_t>;
  std::span<const std::byte>(T::kSettings);
  { T::kHasBrightness } -> std::convertible_to<bool>;
  { T::kId } -> std::convertible_to<std::uint32_t>;
};

/// Returns the controller's traits.
template <DcsController Controller>
constexpr DcsTraits traits_of() {
  if constexpr (requires { Controller::kTraits; }) return Controller::kTraits;
  return {};
}

/// The format of pixels on the bus of a controller, for pixels of `format`.
template <DcsController Controller>
constexpr DisplayFormat wire_format(DisplayFormat format) {
  const bool widens = traits_of<Controller>().widens_565 && format == DisplayFormat::rgb565_swapped;
  return widens ? DisplayFormat::rgb666 : format;
}

/// Read display ID, 04h: on a serial bus a dummy clock, then three bytes.
template <ReadableBus Bus>
Error read_display_id(Bus& bus, std::span<std::byte, 3> id) {
  return bus.read(std::byte{0x04}, 1, id);
}

/// Read ID4, D3h, of Ilitek's controllers: an unused parameter, then three bytes. On a serial bus each read returns one
/// byte; `select` is the command that selects the byte.
template <ReadableBus Bus>
Error read_id4(Bus& bus, std::byte select, std::span<std::byte, 3> id) {
  constexpr std::byte kReadId4{0xD3};
  constexpr unsigned kEnable = 0x10;
  for (unsigned i = 0; i < id.size(); ++i) {
    if (const Error error = send_command(bus, select, kEnable | (i + 1)); error != Error::none) return error;
    if (const Error error = bus.read(kReadId4, 0, id.subspan(i, 1)); error != Error::none) return error;
  }
  return Error::none;
}

/// A display that shows what is written at once. `bus` and `clock` must outlive it. Any rectangle may be written; with
/// rgb444 its width must be even (Error::alignment), as two pixels share a byte; some controllers want even areas.
template <DcsController Controller, CommandDataBus Bus, Clock Time>
class DcsPanel {
 public:
  /// Sends nothing: start() does.
  constexpr DcsPanel(Bus& bus, Time& clock, const DcsConfig& config) : bus_(bus), clock_(clock), config_(config) {}

  /// Resets the controller by command, sets it up, blackens the glass and switches it on. Takes a quarter of a second,
  /// plus the time to send a frame's bytes. May be repeated after an error, best after reset_panel() (output_pin.hpp).
  /// Returns Error::configuration, and sends nothing, if the glass is larger than the controller's memory, the
  /// controller does not support the format or the orientation, module_commands end within a command, `id` is set but
  /// the bus cannot read, or `id` is out of range. Returns Error::wrong_id if the controller answers with another id;
  /// it has sent only the command that reads the id then.
  Error start() {
    if (!valid()) return Error::configuration;
    Error error = checked_id();
    if (error == Error::none) error = command(kSoftReset);
    clock_.wait(kAwakeToReady);
    if (error == Error::none) error = send_commands(bus_, Controller::kSettings);
    if (error == Error::none) error = send_commands(bus_, config_.module_commands);
    if (error == Error::none) error = command(kSleepOut);
    clock_.wait(kAwakeToReady);
    if (error == Error::none) error = command(kPixelFormat, Controller::pixel_format(config_.format));
    if (error == Error::none) error = command(kMemoryAccess, memory_access());
    if (error == Error::none) error = command(config_.inverted ? kInversionOn : kInversionOff);
    if (error == Error::none) error = command(kNormalMode);
    if (error == Error::none) error = set_window({0, 0, width(), height()});
    const DisplayFormat sent = wire_format<Controller>(format());
    if (error == Error::none) error = send_zeros(bus_, bytes_per_row(width(), sent) * height());
    if (error == Error::none) error = command(kDisplayOn);
    return error;
  }

  /// See the concept Display.
  constexpr std::uint16_t width() const { return is_sideways(config_.orientation) ? config_.height : config_.width; }
  /// See the concept Display.
  constexpr std::uint16_t height() const { return is_sideways(config_.orientation) ? config_.width : config_.height; }
  /// See the concept Display.
  constexpr DisplayFormat format() const { return config_.format; }

  /// See the concept Display.
  Error begin_frame() { return Error::none; }
  /// See the concept Display.
  Error write(const Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    if (config_.format == DisplayFormat::rgb444 && area.width % 2 != 0) return Error::alignment;
    if constexpr (kTraits.even_areas) {
      if (!is_even(area.left, area.top, area.width, area.height)) return Error::alignment;
    }
    const std::uint32_t bytes = bytes_per_row(area.width, config_.format) * area.height;
    if (pixels.size() < bytes) return Error::pixels_too_small;
    if (const Error error = set_window(area); error != Error::none) return error;
    if constexpr (kTraits.widens_565) {
      if (wire_format<Controller>(format()) != format()) return widened_.send(bus_, pixels.first(bytes));
    }
    return bus_.write_data(pixels.first(bytes));
  }
  /// See the concept Display.
  Error wait() { return bus_.wait(); }
  /// See the concept Display.
  Error end_frame() { return Error::none; }

  /// Reads the controller's id, in the form of DcsConfig::id. May be called before start(), from 5 ms after a reset on.
  /// All ones or all zeros: no controller answers, or no wire for answers exists. No transfer may be under way.
  Error read_id(std::uint32_t& id) requires(ReadableBus<Bus>&& Controller::kId != 0) {
    std::array<std::byte, 3> answer{};
    const Error error = Controller::read_id(bus_, answer);
    id = 0;
    for (const std::byte byte : answer) id = id << 8 | std::to_integer<std::uint32_t>(byte);
    return error;
  }

  /// Switches the display off, so that it needs nearly no current. The memory keeps its pixels; do not write any until
  /// wake(). Takes 120 ms. The program switches the backlight.
  Error sleep() {
    if (const Error error = command(kDisplayOff); error != Error::none) return error;
    const Error error = command(kSleepIn);
    clock_.wait(kAsleepToReady);
    return error;
  }
  /// Shows the memory again. Takes 120 ms.
  Error wake() {
    const Error error = command(kSleepOut);
    clock_.wait(kAwakeToReady);
    return error != Error::none ? error : command(kDisplayOn);
  }

  /// Sets the brightness of a backlight on the controller's own PWM output, which few modules use: 0 dark .. 255. If
  /// the backlight is on a pin of the board, the board sets its brightness.
  Error set_brightness(std::uint8_t level) requires(Controller::kHasBrightness) {
    if (const Error error = command(kBrightnessControl, kTraits.brightness_control); error != Error::none) return error;
    return command(kBrightness, level);
  }

 private:
  // Commands of the set's user command list; all controllers have them.
  static constexpr std::byte kSoftReset{0x01};
  static constexpr std::byte kSleepIn{0x10};
  static constexpr std::byte kSleepOut{0x11};
  static constexpr std::byte kNormalMode{0x13};
  static constexpr std::byte kInversionOff{0x20};
  static constexpr std::byte kInversionOn{0x21};
  static constexpr std::byte kDisplayOff{0x28};
  static constexpr std::byte kDisplayOn{0x29};
  static constexpr std::byte kColumns{0x2A};
  static constexpr std::byte kRows{0x2B};
  static constexpr std::byte kMemoryWrite{0x2C};
  static constexpr std::byte kMemoryAccess{0x36};
  static constexpr std::byte kPixelFormat{0x3A};
  static constexpr std::byte kBrightness{0x51};
  static constexpr std::byte kBrightnessControl{0x53};
  // Memory access control.
  static constexpr unsigned kReverseRows = 0x80, kReverseColumns = 0x40, kExchange = 0x20, kBgr = 0x08;
  static constexpr std::uint32_t kNobody = 0xFFFFFF;  // read from a wire that is pulled up, or not connected
  // The time after a reset, or between sleep-out and sleep-in, either way; for other commands 5 ms would be enough.
  static constexpr std::uint32_t kAwakeToReady = 120'000, kAsleepToReady = 120'000;  // us

  static constexpr DcsTraits kTraits = traits_of<Controller>();
  struct Nothing {};

  constexpr bool valid() const {
    const auto fits = [](unsigned first, unsigned size, unsigned all) { return size >= 1 && first + size <= all; };
    return fits(config_.column_offset, config_.width, Controller::kColumns) &&
           fits(config_.row_offset, config_.height, Controller::kRows) &&
           Controller::pixel_format(config_.format) != 0 &&
           (config_.format != DisplayFormat::rgb444 || width() % 2 == 0) && is_command_list(config_.module_commands) &&
           (config_.id == 0 || (ReadableBus<Bus> && Controller::kId != 0 && config_.id < kNobody)) &&
           (kTraits.exchanges || !is_sideways(config_.orientation)) &&
           (kTraits.reverses_rows || (memory_access() & kReverseRows) == 0) &&
           (!kTraits.even_areas || is_even(config_.column_offset, config_.width, config_.row_offset, config_.height));
  }
  static constexpr bool is_even(unsigned a, unsigned b, unsigned c, unsigned d) { return ((a | b | c | d) & 1U) == 0; }
  static_assert(is_command_list(Controller::kSettings));

  constexpr std::uint8_t memory_access() const {
    const Scan scan = scan_of(config_.orientation);
    return static_cast<std::uint8_t>((scan.rows_reversed != config_.rows_reversed ? kReverseRows : 0U) |
                                     (scan.columns_reversed != config_.columns_reversed ? kReverseColumns : 0U) |
                                     (scan.exchanged ? kExchange : 0U) | (config_.bgr ? kBgr : 0U));
  }

  Error checked_id() {
    if constexpr (ReadableBus<Bus> && Controller::kId != 0) {
      if (config_.id == 0) return Error::none;
      std::uint32_t found = 0;
      if (const Error error = read_id(found); error != Error::none) return error;
      if (found != config_.id) return Error::wrong_id;
    }
    return Error::none;
  }

  template <class... Parameters>
  Error command(std::byte code, Parameters... parameters) {
    return send_command(bus_, code, parameters...);
  }

  /// Sets the window: the next data goes to the area's upper left corner and fills it row by row.
  Error set_window(const Area& area) {
    // Columns and rows count in the picture's direction; only the offset of the glass in the memory depends on it.
    const Scan scan = scan_of(config_.orientation);
    const auto start = [](bool reversed, unsigned all, unsigned size, unsigned offset) {
      return reversed ? all - size - offset : offset;
    };
    const unsigned column = start(scan.columns_reversed, Controller::kColumns, config_.width, config_.column_offset);
    const unsigned row = start(scan.rows_reversed, Controller::kRows, config_.height, config_.row_offset);
    const unsigned left = area.left + (scan.exchanged ? row : column);
    const unsigned top = area.top + (scan.exchanged ? column : row);
    if (const Error error = range(kColumns, left, area.width); error != Error::none) return error;
    if (const Error error = range(kRows, top, area.height); error != Error::none) return error;
    return command(kMemoryWrite);
  }
  /// Sends first and last, inclusive, high byte first.
  Error range(std::byte code, unsigned first, unsigned count) {
    const unsigned last = first + count - 1;
    return command(code, first >> 8, first & 0xFFU, last >> 8, last & 0xFFU);
  }

  Bus& bus_;
  Time& clock_;
  DcsConfig config_;
  [[no_unique_address]] std::conditional_t<kTraits.widens_565, Widened, Nothing> widened_{};
};

}  // namespace zstrip::hal
