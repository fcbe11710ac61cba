// Solomon Systech SSD1680: controller of black and white e-paper up to 176x296, on a command/data bus with a BUSY line.
// Serial clock up to 20 MHz (50 ns a write cycle).
//
// E-paper keeps its picture without power. A refresh takes from half a second to several seconds, and the driver waits
// for it. A full refresh flashes the whole glass; a partial one moves only pixels that differ from the controller's
// second memory, which must hold the picture on the glass. The controller cannot return a rectangle of the frame
// before, so the driver keeps the picture, one bit a pixel, in memory that the caller lends: then frames may
// write any rectangle, at any pixel, in any orientation, and only rows that differ are sent.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/clock.hpp"
#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"
#include "zstrip_hal/input_pin.hpp"
#include "zstrip_hal/orientation.hpp"
#include "zstrip_hal/parameters.hpp"

namespace zstrip::hal {

/// The wiring of the glass, its refreshes, and the orientation of the picture. The defaults suit modules of 2.9 inches;
/// those of 2.13 inches have 122x250.
struct Ssd1680Config {
  std::uint16_t width = 128;          ///< pixels of the upright glass, 1 up to 176
  std::uint16_t height = 296;         ///< pixels of the upright glass, 1 up to 296
  std::uint16_t column_offset = 0;    ///< columns of the controller's memory left of the glass, a multiple of 8
  Orientation orientation{};          ///< of the picture on the glass
  bool sources_from_8 = true;         ///< the glass is wired to the source lines S8 to S167, as most are; else from S0
  std::uint8_t partials = 10;         ///< partial refreshes from one full refresh to the next; 0: all are full
  std::uint16_t busy_limit = 10'000;  ///< ms that the panel may be busy in one go; a full refresh in the cold takes 8 s
};

/// A display of one bit a pixel, white where a pixel is lit; scenes are drawn dithered. write() stores in the caller's
/// memory; end_frame() sends the rows that differ from the glass, refreshes it, and waits until that is done. A frame
/// in which nothing differs sends nothing. After an error of end_frame() the next frame sends all and refreshes fully.
/// `bus`, `clock` and `memory` must outlive the display. `busy` is high while the panel is busy.
template <CommandDataBus Bus, InputPin BusyPin, Clock Time>
class Ssd1680 {
 public:
  static constexpr std::uint16_t kColumns = 176;  ///< columns of the controller's memory
  static constexpr std::uint16_t kRows = 296;     ///< rows of the controller's memory

  /// Bytes of memory that the display needs: 4,736 for 128x296.
  static constexpr std::uint32_t memory_bytes(const Ssd1680Config& config) {
    return bytes_per_row(config.width, DisplayFormat::mono) * config.height;
  }

  /// Sends nothing: start() does.
  constexpr Ssd1680(Bus& bus, BusyPin busy, Time& clock, std::span<std::byte> memory, const Ssd1680Config& config = {})
      : bus_(bus), busy_(std::move(busy)), clock_(clock), memory_(memory), config_(config) {}

  /// Sets the controller up, and makes the memory black. The glass keeps its picture until the first frame, which
  /// refreshes it fully. Takes 10 ms. Call it after reset_panel() (output_pin.hpp); may be repeated. Returns
  /// Error::configuration if the glass does not fit the controller, Error::framebuffer if `memory` is too small, and
  /// sends nothing then; Error::timeout if the panel stays busy, as it does in deep sleep.
  Error start() {
    if (!fits()) return Error::configuration;
    if (memory_.size() < memory_bytes(config_)) return Error::framebuffer;
    for (std::byte& byte : memory_) byte = std::byte{0};
    forget_glass();
    Error error = ready();
    if (error == Error::none) error = send_command(bus_, kSoftReset);
    clock_.wait(kResetTime);
    if (error == Error::none) error = ready();
    const unsigned lines = config_.height - 1U;
    if (error == Error::none) error = send_command(bus_, kDriverOutput, lines & 0xFFU, lines >> 8, 0);
    if (error == Error::none) error = send_command(bus_, kDataEntry, kRightThenDown);
    if (error == Error::none) error = send_command(bus_, kUpdateControl, 0, config_.sources_from_8 ? 0x80 : 0x00);
    if (error == Error::none) error = send_command(bus_, kTemperatureSensor, kInternal);
    return error;
  }

  /// @{
  /// See the concept Display. Any rectangle may be written.
  constexpr std::uint16_t width() const { return is_sideways(config_.orientation) ? config_.height : config_.width; }
  constexpr std::uint16_t height() const { return is_sideways(config_.orientation) ? config_.width : config_.height; }
  constexpr DisplayFormat format() const { return DisplayFormat::mono; }

  Error begin_frame() { return Error::none; }
  Error write(const Area& area, std::span<const std::byte> pixels) {
    if (!contains(width(), height(), area)) return Error::area;
    const std::uint32_t row_bytes = bytes_per_row(area.width, DisplayFormat::mono);
    if (pixels.size() < row_bytes * area.height) return Error::pixels_too_small;
    if (memory_.size() < memory_bytes(config_)) return Error::framebuffer;
    const Scan scan = scan_of(config_.orientation);
    for (unsigned y = 0; y < area.height; ++y) {
      const std::span<const std::byte> row = pixels.subspan(y * row_bytes, row_bytes);
      for (unsigned x = 0; x < area.width; ++x) {
        const bool lit = (row[x / 8] & static_cast<std::byte>(0x80U >> (x % 8))) != std::byte{0};
        unsigned column = area.left + x, line = area.top + y;
        if (scan.exchanged) std::swap(column, line);
        store(scan.columns_reversed ? config_.width - 1U - column : column,
              scan.rows_reversed ? config_.height - 1U - line : line, lit);
      }
    }
    return Error::none;
  }
  Error wait() { return Error::none; }
  /// Error::timeout if the panel is busy for longer than the configuration's limit.
  Error end_frame() {
    if (first_ >= end_) return Error::none;
    const Error error = refreshed_ == kUnknown || refreshed_ >= config_.partials ? refresh_fully() : refresh_partly();
    if (error != Error::none) {
      forget_glass();
      return error;
    }
    first_ = kRows;
    end_ = 0;
    return Error::none;
  }
  /// @}

  /// Makes the next frame a full refresh, even if nothing differs: it removes the remains of earlier pictures.
  void clean() { forget_glass(); }

  /// Deep sleep: nearly no current; the glass keeps its picture. reset_panel() and start() end it.
  Error sleep() { return send_command(bus_, std::byte{0x10}, 0x01); }

 private:
  static constexpr std::byte kDriverOutput{0x01};
  static constexpr std::byte kDataEntry{0x11};
  static constexpr std::byte kSoftReset{0x12};
  static constexpr std::byte kTemperatureSensor{0x18};
  static constexpr std::byte kActivate{0x20};
  static constexpr std::byte kUpdateControl{0x21};
  static constexpr std::byte kUpdateSequence{0x22};
  static constexpr std::byte kWrite{0x24};          // the picture to show
  static constexpr std::byte kWritePrevious{0x26};  // the picture that the glass shows
  static constexpr std::byte kBorder{0x3C};
  static constexpr unsigned kRightThenDown = 0x03, kInternal = 0x80;
  // Clock and supply on, temperature, waveform, refresh, supply and clock off; bit 3 makes it partial.
  static constexpr unsigned kFull = 0xF7, kPartial = 0xFF;
  static constexpr unsigned kBorderFollows = 0x05, kBorderRests = 0x80;
  static constexpr std::uint32_t kResetTime = 10'000, kPoll = 1'000;  // us
  static constexpr std::uint16_t kUnknown = 0xFFFF;

  constexpr bool fits() const {
    return config_.width >= 1 && config_.column_offset % 8 == 0 && config_.column_offset + config_.width <= kColumns &&
           config_.height >= 1 && config_.height <= kRows;
  }

  /// The picture on the glass is unknown: all rows count as different, and a partial refresh would be wrong.
  void forget_glass() {
    refreshed_ = kUnknown;
    first_ = 0;
    end_ = config_.height;
  }

  /// Column and row are those of the upright glass.
  void store(unsigned column, unsigned row, bool lit) {
    std::byte& byte = memory_[row * bytes_per_row(config_.width, DisplayFormat::mono) + column / 8];
    const auto bit = static_cast<std::byte>(0x80U >> (column % 8));
    if (((byte & bit) != std::byte{0}) == lit) return;
    byte ^= bit;
    if (row < first_) first_ = static_cast<std::uint16_t>(row);
    if (row >= end_) end_ = static_cast<std::uint16_t>(row + 1);
  }

  /// Waits until the panel is not busy.
  Error ready() {
    for (std::uint32_t waited = 0;; ++waited) {
      bool busy = true;
      if (const Error error = busy_.read(busy); error != Error::none) return error;
      if (!busy) return Error::none;
      if (waited >= config_.busy_limit) return Error::timeout;
      clock_.wait(kPoll);
    }
  }

  /// Both memories get the picture: the waveform of some glasses depends on the second one.
  Error refresh_fully() {
    first_ = 0;
    end_ = config_.height;
    Error error = ready();
    if (error == Error::none) error = send_rows(kWrite);
    if (error == Error::none) error = send_rows(kWritePrevious);
    if (error == Error::none) error = refresh(kFull, kBorderFollows);
    if (error == Error::none) refreshed_ = 0;
    return error;
  }
  /// Afterwards both memories get the rows: some glasses exchange the memories at each partial refresh.
  Error refresh_partly() {
    Error error = ready();
    if (error == Error::none) error = send_rows(kWrite);
    if (error == Error::none) error = refresh(kPartial, kBorderRests);
    if (error == Error::none) error = send_rows(kWrite);
    if (error == Error::none) error = send_rows(kWritePrevious);
    if (error == Error::none) ++refreshed_;
    return error;
  }
  Error refresh(unsigned sequence, unsigned border) {
    Error error = send_command(bus_, kBorder, border);
    if (error == Error::none) error = send_command(bus_, kUpdateSequence, sequence);
    if (error == Error::none) error = send_command(bus_, kActivate);
    return error == Error::none ? ready() : error;
  }

  /// Sends the rows that differ. The controller counts columns in bytes.
  Error send_rows(std::byte memory) {
    const std::uint32_t row_bytes = bytes_per_row(config_.width, DisplayFormat::mono);
    const unsigned left = config_.column_offset / 8U, right = left + row_bytes - 1U, last = end_ - 1U;
    Error error = send_command(bus_, std::byte{0x44}, left, right);
    if (error == Error::none) {
      error = send_command(bus_, std::byte{0x45}, first_ & 0xFFU, first_ >> 8U, last & 0xFFU, last >> 8U);
    }
    if (error == Error::none) error = send_command(bus_, std::byte{0x4E}, left);
    if (error == Error::none) error = send_command(bus_, std::byte{0x4F}, first_ & 0xFFU, first_ >> 8U);
    if (error == Error::none) error = send_command(bus_, memory);
    if (error == Error::none) error = bus_.write_data(memory_.subspan(first_ * row_bytes, (end_ - first_) * row_bytes));
    return error == Error::none ? bus_.wait() : error;
  }

  Bus& bus_;
  BusyPin busy_;
  Time& clock_;
  std::span<std::byte> memory_;  // rows of the upright glass
  Ssd1680Config config_;
  std::uint16_t first_ = 0, end_ = 0;   // rows that differ from the glass
  std::uint16_t refreshed_ = kUnknown;  // partial refreshes since the last full one
};

}  // namespace zstrip::hal
