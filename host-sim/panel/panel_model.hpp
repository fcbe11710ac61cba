// What every model of a panel has: the wires, time, and a list of what the real part would not have taken.
//
// The models are written from the command tables and timing tables of the controllers' data sheets, and share no code
// with the drivers in hal, so that one can judge the other.
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

/// A controller with its glass. Powered on, its reset line high long enough, its memory full of noise.
/// After a complaint the model goes on as the part most likely would.
class PanelModel {
 public:
  PanelModel() = default;
  PanelModel(const PanelModel&) = delete;
  PanelModel& operator=(const PanelModel&) = delete;
  virtual ~PanelModel() = default;

  /// Time passes.
  void elapse(Nanoseconds time) { now_ += time; }
  Nanoseconds now() const { return now_; }
  /// Bytes arrive, at the time of now().
  void receive(Wire wire, std::span<const std::byte> bytes);
  /// One bit's time on the bus, to be set once: complains where the data sheet requires more.
  void clocked_at(Nanoseconds cycle);
  /// A command arrives, and the clock runs on for so many bits, of `cycle` each: the levels of the panel's data output.
  /// What it does not drive is high.
  std::vector<bool> ask(std::uint8_t command, std::size_t bits, Nanoseconds cycle);
  /// The reset line.
  void set_reset(bool high);
  /// The driver breaks the contract of its bus.
  void driver_broke(std::string what) { complain(std::move(what)); }
  /// The bus gave up amid a transfer: whatever was incomplete is excused.
  virtual void interrupted() = 0;

  /// What the eye sees, the glass upright; black where nothing is shown.
  virtual RgbImage seen() const = 0;
  /// Why the glass is dark; empty if it shows its memory.
  virtual std::string darkness() const = 0;
  /// Of the light that the controller governs, a backlight's or its own pixels': 0 dark .. 255; none if it governs
  /// none.
  virtual std::optional<unsigned> brightness() const { return std::nullopt; }
  /// Each once, in order.
  const std::vector<std::string>& complaints() const { return complaints_; }
  void forgive() { complaints_.clear(); }

  /// The shortest cycle of the serial clock for writing, and for reading.
  virtual Nanoseconds shortest_cycle() const = 0;
  virtual Nanoseconds shortest_read_cycle() const { return 0ns; }

 protected:
  virtual void receive_byte(Wire wire, std::uint8_t byte) = 0;
  /// All bits that answer a command which has just arrived, dummy clocks too. Most parts have no output on a serial
  /// bus.
  virtual std::vector<bool> answer(std::uint8_t command);
  /// Registers and timing as after a reset by the line; memory stays.
  virtual void reset() = 0;
  /// The reset line's pulse at least, and whether the part exists without one.
  virtual Nanoseconds shortest_reset() const = 0;

  void complain(std::string what);

 private:
  Nanoseconds now_ = 0ns;
  Nanoseconds reset_since_ = 0ns;
  bool in_reset_ = false;
  std::vector<std::string> complaints_;
};

}  // namespace zstrip::sim
