// The common parts of all models of panels: wires, time, and a list of inputs that the real part would not accept.
//
// The models are written from the command tables and timing tables of the controllers' data sheets, or from what public
// drivers agree on (docs/panels.md says which). They share no code with the drivers in hal, so that they can check
// them.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "image/rgb_image.hpp"

namespace zstrip::sim {

using Nanoseconds = std::chrono::nanoseconds;
using std::chrono_literals::operator""ns;
using std::chrono_literals::operator""us;
using std::chrono_literals::operator""ms;

/// The level of the D/C line.
enum class Wire : std::uint8_t { command, data };

/// A controller with its glass. It is powered on, its reset line was high long enough, and its memory is full of noise.
/// After a complaint the model continues as the part probably would.
class PanelModel {
 public:
  PanelModel() = default;
  PanelModel(const PanelModel&) = delete;
  PanelModel& operator=(const PanelModel&) = delete;
  virtual ~PanelModel() = default;

  /// Advances the time.
  void elapse(Nanoseconds time) { now_ += time; }
  Nanoseconds now() const { return now_; }
  /// Receives bytes, at the time now().
  void receive(Wire wire, std::span<const std::byte> bytes);
  /// Receives a transfer on QSPI, at the time now(): `header` on one line, `data` on `lines`.
  void receive_phases(std::span<const std::byte> header, std::span<const std::byte> data, unsigned lines);
  /// Sets the time of one bit on the bus, once; complains if the data sheet requires more.
  void clocked_at(Nanoseconds cycle);
  /// Receives a command, then runs the clock for so many bits, of `cycle` each. Returns the levels of the panel's data
  /// output; bits that the panel does not drive are high.
  std::vector<bool> ask(std::uint8_t command, std::size_t bits, Nanoseconds cycle);
  /// Sets the reset line.
  void set_reset(bool high);
  /// Reports that the driver broke the contract of its bus.
  void driver_broke(std::string what) { complain(std::move(what)); }
  /// Reports that the bus stopped in a transfer: incomplete commands then are not complained about.
  virtual void interrupted() = 0;

  /// Returns the visible picture with the glass upright; black if nothing is shown.
  virtual RgbImage seen() const = 0;
  /// Returns the reason why the glass is dark; empty if it shows its memory.
  virtual std::string darkness() const = 0;
  /// Returns the brightness of the light that the controller sets, that of a backlight or of its own pixels: 0
  /// dark..255; nothing if it sets none.
  virtual std::optional<unsigned> brightness() const { return std::nullopt; }
  /// Returns the time that the panel has taken to refresh its glass, in which it accepts nothing.
  virtual Nanoseconds refreshing() const { return 0ns; }
  /// Returns each complaint once, in order.
  const std::vector<std::string>& complaints() const { return complaints_; }
  void forgive() { complaints_.clear(); }

  /// Returns the shortest cycle of the serial clock for writing; shortest_read_cycle() for reading.
  virtual Nanoseconds shortest_cycle() const = 0;
  virtual Nanoseconds shortest_read_cycle() const { return 0ns; }

 protected:
  virtual void receive_byte(Wire wire, std::uint8_t byte) = 0;
  /// Executes a transfer on QSPI. Most parts have none.
  virtual void execute_phases(std::span<const std::byte> header, std::span<const std::byte> data, unsigned lines);
  /// Returns all bits of the answer to the last command, including dummy clocks. Most parts have no output on a serial
  /// bus.
  virtual std::vector<bool> answer(std::uint8_t command);
  /// Sets registers and timing as after a reset by the line; memory keeps its contents.
  virtual void reset() = 0;
  /// Returns the shortest low pulse of the reset line.
  virtual Nanoseconds shortest_reset() const = 0;

  void complain(std::string what);

 private:
  Nanoseconds now_ = 0ns;
  Nanoseconds reset_since_ = 0ns;
  bool in_reset_ = false;
  std::vector<std::string> complaints_;
};

}  // namespace zstrip::sim
