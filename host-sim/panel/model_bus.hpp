// The wires between a driver and the model of a panel: a command/data bus with a speed, whose time the model lives in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "panel/panel_model.hpp"
#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/clock.hpp"

namespace zstrip::sim {

/// What comes before the bytes of a transfer, and what each byte takes.
struct BusTiming {
  Nanoseconds byte{};      ///< of eight bits, and of a ninth where there is one
  Nanoseconds transfer{};  ///< of each transfer besides: address and control bytes of I2C
  Nanoseconds cycle{};     ///< of the clock
};

/// What the panel's data output is wired to: the bus, or nothing, so that the bus reads one level.
enum class AnswerWire : std::uint8_t { wired, low, high };

/// Data is taken as late as the contract of a bus allows, in wait(): a buffer that is drawn into too early shows.
/// Doubles as the clock that a driver waits with. The bytes and the time since the start can be read off.
class ModelBus {
 public:
  ModelBus(PanelModel& panel, const BusTiming& timing);

  hal::Error write_command(std::span<const std::byte> bytes);
  hal::Error write_data(std::span<const std::byte> bytes);
  hal::Error wait();
  /// At 2 MHz at most, as buses read whose panels are written to faster than they can answer.
  hal::Error read(std::byte command, unsigned dummy_clocks, std::span<std::byte> answer);
  void wait(std::uint32_t microseconds);

  std::uint64_t bytes() const { return bytes_; }
  /// That the bus was busy.
  Nanoseconds busy() const { return busy_; }

  /// The transfer of this number, counted from 0, fails; of its bytes so many quarters arrive.
  void fail_at(int transfer, unsigned quarters) {
    fail_at_ = transfer;
    quarters_ = quarters;
  }
  int transfers() const { return transfers_; }
  void wire_answers(AnswerWire wire) { answers_ = wire; }

 private:
  hal::Error send(Wire wire, std::span<const std::byte> bytes);

  PanelModel& panel_;
  BusTiming timing_;
  std::span<const std::byte> sending_;
  bool is_sending_ = false;
  std::uint64_t bytes_ = 0;
  Nanoseconds busy_{};
  int fail_at_ = -1;
  unsigned quarters_ = 0;
  int transfers_ = 0;
  AnswerWire answers_ = AnswerWire::wired;
};

static_assert(hal::ReadableBus<ModelBus>);
static_assert(hal::Clock<ModelBus>);

}  // namespace zstrip::sim
