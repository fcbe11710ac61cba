// The wires between a driver and the model of a panel: a command/data bus with a speed, which sets the model's time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "panel/panel_model.hpp"
#include "zstrip_hal/bus.hpp"
#include "zstrip_hal/clock.hpp"
#include "zstrip_hal/qspi.hpp"

namespace zstrip::sim {

/// The time before the bytes of a transfer, and the time of each byte.
struct BusTiming {
  Nanoseconds byte{};      ///< eight bits, or nine with an acknowledge
  Nanoseconds transfer{};  ///< additional time of each transfer: address and control byte of I2C
  Nanoseconds cycle{};     ///< one cycle of the clock
};

/// The wiring of the panel's data output: to the bus, or to a constant level that the bus reads.
enum class AnswerWire : std::uint8_t { wired, low, high };

/// Takes data as late as the contract of a bus allows, in wait(), so that drawing into a buffer too early is visible.
/// Also serves as the clock with which a driver waits. Bytes and time since the start can be read.
class ModelBus {
 public:
  ModelBus(PanelModel& panel, const BusTiming& timing);

  hal::Error write_command(std::span<const std::byte> bytes);
  hal::Error write_data(std::span<const std::byte> bytes);
  hal::Error wait();
  /// Transfers on QSPI: `header` on one line, then `data` on 1 or 4. They are taken in wait(), too.
  hal::Error write(std::span<const std::byte, 4> header, std::span<const std::byte> data, unsigned lines);
  /// At most 2 MHz: buses read slowly from panels that can be written to faster than they answer.
  hal::Error read(std::byte command, unsigned dummy_clocks, std::span<std::byte> answer);
  void wait(std::uint32_t microseconds);

  std::uint64_t bytes() const { return bytes_; }
  /// Returns the time in which the bus was busy.
  Nanoseconds busy() const { return busy_; }

  /// Makes the transfer of this number, counted from 0, fail; so many quarters of its bytes arrive.
  void fail_at(int transfer, unsigned quarters) {
    fail_at_ = transfer;
    quarters_ = quarters;
  }
  int transfers() const { return transfers_; }
  void wire_answers(AnswerWire wire) { answers_ = wire; }

 private:
  hal::Error send(Wire wire, std::span<const std::byte> bytes);
  hal::Error send_phases();

  PanelModel& panel_;
  BusTiming timing_;
  std::span<const std::byte> sending_;
  bool is_sending_ = false;
  std::array<std::byte, 4> header_{};
  unsigned lines_ = 0;  // of the data of a transfer on QSPI; 0: not QSPI
  std::uint64_t bytes_ = 0;
  Nanoseconds busy_{};
  int fail_at_ = -1;
  unsigned quarters_ = 0;
  int transfers_ = 0;
  AnswerWire answers_ = AnswerWire::wired;
};

static_assert(hal::ReadableBus<ModelBus>);
static_assert(hal::QuadSpi<ModelBus>);
static_assert(hal::Clock<ModelBus>);

}  // namespace zstrip::sim
