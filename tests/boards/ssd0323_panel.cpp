// The controller's command table and memory.
#include "ssd0323_panel.hpp"

namespace zstrip::boards {
namespace {

/// Parameters that follow a command, or -1 if there is no such command.
int parameters(std::uint8_t command) {
  switch (command) {
    case 0x15:
    case 0x75: return 2;
    case 0x84:
    case 0x85:
    case 0x86:
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
    case 0xAE:
    case 0xAF:
    case 0xE3: return 0;
    case 0x81:
    case 0xA0:
    case 0xA1:
    case 0xA2:
    case 0xA8:
    case 0xAD:
    case 0xB0:
    case 0xB1:
    case 0xB2:
    case 0xB3:
    case 0xB4:
    case 0xBC:
    case 0xBE:
    case 0xBF: return 1;
    case 0xB8: return 8;
    default: return -1;
  }
}

}  // namespace

std::array<std::uint8_t, Ssd0323Panel::kColumns * Ssd0323Panel::kRows> Ssd0323Panel::noise() {
  std::array<std::uint8_t, kColumns * kRows> memory;
  std::uint32_t state = 1;
  for (std::uint8_t& byte : memory) {
    state = state * 1664525U + 1013904223U;
    byte = static_cast<std::uint8_t>(state >> 24);
  }
  return memory;
}

void Ssd0323Panel::complain(const std::string& what) {
  if (complaint_.empty()) complaint_ = what;
}

hal::Error Ssd0323Panel::write_command(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) {
    command_.push_back(std::to_integer<std::uint8_t>(byte));
    const int count = parameters(command_.front());
    if (count < 0) complain("unknown command " + std::to_string(command_.front()));
    if (static_cast<int>(command_.size()) - 1 < count) continue;
    execute();
    command_.clear();
  }
  return hal::Error::none;
}

hal::Error Ssd0323Panel::write_data(std::span<const std::byte> bytes) {
  if (!command_.empty()) complain("data in the middle of a command");
  for (const std::byte byte : bytes) {
    memory_[static_cast<std::size_t>(row_ * kColumns + column_)] = std::to_integer<std::uint8_t>(byte);
    if (++column_ <= last_column_) continue;
    column_ = first_column_;
    row_ = row_ == last_row_ ? first_row_ : row_ + 1;
  }
  return hal::Error::none;
}

void Ssd0323Panel::execute() {
  const std::uint8_t first = command_.size() > 1 ? command_[1] : 0;
  switch (command_.front()) {
    case 0x15:
      if (command_[1] > command_[2] || command_[2] >= kColumns) return complain("columns out of order or range");
      first_column_ = column_ = command_[1];
      last_column_ = command_[2];
      break;
    case 0x75:
      if (command_[1] > command_[2] || command_[2] >= kRows) return complain("rows out of order or range");
      first_row_ = row_ = command_[1];
      last_row_ = command_[2];
      break;
    case 0x81:
      if (first > 127) complain("contrast out of range");
      contrast_ = first;
      break;
    case 0xA0: remap_ = first; break;
    case 0xA1:
      if (first >= kRows) complain("start line out of range");
      start_line_ = first;
      break;
    case 0xA2:
      if (first >= kRows) complain("offset out of range");
      offset_ = first;
      break;
    case 0xA4: normal_ = true; break;
    case 0xA5:
    case 0xA6:
    case 0xA7: normal_ = false; break;
    case 0xA8:
      if (first < 15 || first >= kRows) complain("multiplex ratio out of range");
      multiplex_ = first;
      break;
    case 0xAD:
      if ((first & 0xFEU) != 0x02) complain("master configuration must be 2 or 3");
      supplied_ = true;
      break;
    case 0xAE: on_ = false; break;
    case 0xAF: on_ = true; break;
    case 0xB8: {
      // Pulse lengths as increases over the level below: level 1 stands alone, then two levels a byte. Each must grow.
      grey_table_ = (command_[1] & 0x07U) > 0;
      for (std::size_t index = 2; index <= 8; ++index) {
        if ((command_[index] & 0x07U) == 0 || (command_[index] >> 4) == 0) complain("grey levels do not grow");
      }
      break;
    }
    default: break;  // timing and voltages: any value shows a picture
  }
}

std::optional<GreyPicture> Ssd0323Panel::seen() const {
  constexpr std::uint8_t kHighNibbleLeft = 0x02, kDownwards = 0x04;
  const bool set_up = on_ && normal_ && supplied_ && grey_table_ && contrast_ > 0 && start_line_ == 0 && offset_ &&
                      multiplex_ == 63 && remap_ && (*remap_ & kDownwards) == 0;
  if (!set_up) return std::nullopt;
  GreyPicture picture{2 * kColumns, 64, {}};
  for (std::size_t index = 0; index < std::size_t{kColumns} * 64; ++index) {
    const auto high = static_cast<std::uint8_t>(memory_[index] >> 4);
    const auto low = static_cast<std::uint8_t>(memory_[index] & 15U);
    const bool high_left = (*remap_ & kHighNibbleLeft) != 0;
    picture.levels.push_back(high_left ? high : low);
    picture.levels.push_back(high_left ? low : high);
  }
  return picture;
}

}  // namespace zstrip::boards
