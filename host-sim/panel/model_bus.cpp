// Transfers: time, lateness and faults.
#include "panel/model_bus.hpp"

namespace zstrip::sim {

ModelBus::ModelBus(PanelModel& panel, const BusTiming& timing) : panel_(panel), timing_(timing) {
  panel_.clocked_at(timing_.cycle);
}

hal::Error ModelBus::send(Wire wire, std::span<const std::byte> bytes) {
  const bool fails = transfers_++ == fail_at_;
  if (fails) bytes = bytes.first(bytes.size() * quarters_ / 4);
  const Nanoseconds time = timing_.transfer + bytes.size() * timing_.byte;
  panel_.elapse(time);
  panel_.receive(wire, bytes);
  bytes_ += bytes.size();
  busy_ += time;
  if (fails) panel_.interrupted();
  return fails ? hal::Error::bus : hal::Error::none;
}

hal::Error ModelBus::write_command(std::span<const std::byte> bytes) {
  if (is_sending_) panel_.driver_broke("a command while data is being sent");
  return send(Wire::command, bytes);
}

hal::Error ModelBus::write_data(std::span<const std::byte> bytes) {
  if (is_sending_) panel_.driver_broke("data while other data is being sent");
  sending_ = bytes;
  is_sending_ = true;
  return hal::Error::none;
}

hal::Error ModelBus::wait() {
  if (!is_sending_) return hal::Error::none;
  is_sending_ = false;
  return send(Wire::data, sending_);
}

void ModelBus::wait(std::uint32_t microseconds) { panel_.elapse(std::chrono::microseconds(microseconds)); }

}  // namespace zstrip::sim
