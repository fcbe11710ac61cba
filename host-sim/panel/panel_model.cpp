// The wires of a panel, time, and complaints.
#include "panel/panel_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace zstrip::sim {

void PanelModel::receive(Wire wire, std::span<const std::byte> bytes) {
  if (in_reset_ && !bytes.empty()) complain("bytes while the reset line is low");
  if (in_reset_) return;
  for (const std::byte byte : bytes) receive_byte(wire, std::to_integer<std::uint8_t>(byte));
}

void PanelModel::receive_phases(std::span<const std::byte> header, std::span<const std::byte> data, unsigned lines) {
  if (in_reset_) return complain("bytes while the reset line is low");
  execute_phases(header, data, lines);
}

void PanelModel::execute_phases(std::span<const std::byte> /*header*/, std::span<const std::byte> /*data*/,
                                unsigned /*lines*/) {
  complain("a transfer on QSPI, which this part does not have");
}

void PanelModel::clocked_at(Nanoseconds cycle) {
  if (cycle >= shortest_cycle()) return;
  complain(fmt::format("the bus sends a bit in {} ns, the controller's data sheet requires at least {} ns",
                       cycle.count(), shortest_cycle().count()));
}

std::vector<bool> PanelModel::ask(std::uint8_t command, std::size_t bits, Nanoseconds cycle) {
  if (cycle < shortest_read_cycle()) {
    complain(fmt::format("the bus reads a bit in {} ns, the controller's data sheet requires at least {} ns",
                         cycle.count(), shortest_read_cycle().count()));
  }
  std::vector<bool> levels;
  if (in_reset_) {
    complain("bytes while the reset line is low");
  } else {
    levels = answer(command);
  }
  levels.resize(bits, true);
  return levels;
}

std::vector<bool> PanelModel::answer(std::uint8_t command) {
  complain(fmt::format("command {:02X}h is to be answered, which this part does not do on a serial bus", command));
  return {};
}

void PanelModel::set_reset(bool high) {
  if (high == !in_reset_) return;
  in_reset_ = !high;
  if (in_reset_) {
    reset_since_ = now_;
  } else if (now_ - reset_since_ < shortest_reset()) {
    complain(fmt::format("the reset line was low for {} ns, at least {} ns are needed", (now_ - reset_since_).count(),
                         shortest_reset().count()));
  } else {
    reset();
  }
}

void PanelModel::complain(std::string what) {
  if (std::ranges::find(complaints_, what) == complaints_.end()) complaints_.push_back(std::move(what));
}

}  // namespace zstrip::sim
