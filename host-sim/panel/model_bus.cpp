// Transfers: time, lateness and faults.
#include "panel/model_bus.hpp"

#include <algorithm>
#include <vector>

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
  return lines_ != 0 ? send_phases() : send(Wire::data, sending_);
}

hal::Error ModelBus::write(std::span<const std::byte, 4> header, std::span<const std::byte> data, unsigned lines) {
  if (is_sending_) panel_.driver_broke("a transfer while another is under way");
  if (lines != 1 && lines != 4) panel_.driver_broke("data on other than 1 or 4 lines");
  std::ranges::copy(header, header_.begin());
  sending_ = data;
  lines_ = lines;
  is_sending_ = true;
  return hal::Error::none;
}

hal::Error ModelBus::send_phases() {
  const bool fails = transfers_++ == fail_at_;
  const std::span<const std::byte> data = sending_.first(fails ? sending_.size() * quarters_ / 4 : sending_.size());
  const std::size_t cycles = 8 * header_.size() + 8 * data.size() / lines_;
  const Nanoseconds time = cycles * timing_.cycle;
  panel_.elapse(time);
  if (!fails || quarters_ != 0) panel_.receive_phases(header_, data, lines_);
  bytes_ += header_.size() + data.size();
  busy_ += time;
  lines_ = 0;
  if (fails) panel_.interrupted();
  return fails ? hal::Error::bus : hal::Error::none;
}

hal::Error ModelBus::read(std::byte command, unsigned dummy_clocks, std::span<std::byte> answer) {
  if (is_sending_) panel_.driver_broke("a question while data is being sent");
  const Nanoseconds cycle = std::max(timing_.cycle, Nanoseconds(500));
  const std::size_t bits = dummy_clocks + 8 * answer.size();
  const Nanoseconds time = timing_.transfer + (8 + bits) * cycle;
  panel_.elapse(time);
  busy_ += time;
  const bool fails = transfers_++ == fail_at_;
  std::vector<bool> levels;  // any values if the question does not arrive
  if (!fails || quarters_ != 0) levels = panel_.ask(std::to_integer<std::uint8_t>(command), bits, cycle);
  levels.resize(bits);
  if (answers_ != AnswerWire::wired) levels.assign(bits, answers_ == AnswerWire::high);
  for (std::size_t i = 0; i < 8 * answer.size(); ++i) {
    answer[i / 8] = (answer[i / 8] << 1) | static_cast<std::byte>(levels[dummy_clocks + i] ? 1 : 0);
  }
  bytes_ += 1 + answer.size();
  if (fails) panel_.interrupted();
  return fails ? hal::Error::bus : hal::Error::none;
}

void ModelBus::wait(std::uint32_t microseconds) { panel_.elapse(std::chrono::microseconds(microseconds)); }

}  // namespace zstrip::sim
