// Commands, address counters, memory, and the picture on the glass.
#include "panel/dcs_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace zstrip::sim {
namespace {

// MADCTL
constexpr std::uint8_t kRowOrder = 0x80, kColumnOrder = 0x40, kRowColumnExchange = 0x20, kBgrOrder = 0x08;

/// Returns noise, the same in each run.
std::uint8_t noise(std::mt19937& random) { return static_cast<std::uint8_t>(random() >> 26); }

/// Converts a channel of the bus to the memory's 6 bits by repeating its upper bits.
std::uint8_t six_bits(std::uint32_t channel, unsigned bits) {
  const std::uint32_t twice = channel << bits | channel;
  return static_cast<std::uint8_t>(twice >> (2 * bits - 6));
}

}  // namespace

DcsModel::DcsModel(const DcsPart& part, const Glass& glass)
    : part_(part), glass_(glass), memory_(std::size_t{part.columns} * part.rows) {
  std::mt19937 random;
  for (Colour& colour : memory_) colour = {noise(random), noise(random), noise(random)};
  reset();
}

void DcsModel::reset() {
  asleep_ = true;
  on_ = inverted_ = idle_ = partial_ = false;
  access_ = 0;
  format_ = part_.format_after_reset;
  brightness_ = brightness_control_ = 0;
  scroll_ = 0;
  read_index_ = 0;
  keys_given_ = 0;
  columns_ = {0, part_.columns - 1U};
  rows_ = {0, part_.rows - 1U};
  command_ = nullptr;
  writing_ = wrote_ = false;
  next_command_ = now() + part_.reset_to_command;
  next_sleep_out_ = now() + part_.reset_to_sleep_out;
}

void DcsModel::interrupted() { excused_ = true; }

void DcsModel::complain_of(const char* what) { complain(fmt::format("{}, command {:02X}h", what, code_)); }

void DcsModel::receive_byte(Wire wire, std::uint8_t byte) {
  if (part_.has_qspi) return complain("a byte with D/C, which is not on QSPI");
  take(wire, byte);
}

/// 02h: a command and its parameters on one line. 32h: pixels on four, only behind the two commands that write them.
void DcsModel::execute_phases(std::span<const std::byte> header, std::span<const std::byte> data, unsigned lines) {
  if (!part_.has_qspi) return PanelModel::execute_phases(header, data, lines);
  const auto at = [header](std::size_t i) { return std::to_integer<std::uint8_t>(header[i]); };
  const std::uint8_t opcode = at(0), code = at(2);
  if (opcode != 0x02 && opcode != 0x32)
    return complain(fmt::format("the {} has no opcode {:02X}h", part_.name, opcode));
  if (at(1) != 0 || at(3) != 0) return complain(fmt::format("command {:02X}h is not between two zeros", code));
  const bool writes = code == 0x2C || code == 0x3C;
  if (opcode == 0x32 && !writes)
    return complain(fmt::format("command {:02X}h by opcode 32h, which is for pixels", code));
  if (lines != (opcode == 0x32 ? 4U : 1U))
    return complain(fmt::format("opcode {:02X}h with data on {} lines", opcode, lines));
  take(Wire::command, code);
  for (const std::byte byte : data) take(Wire::data, std::to_integer<std::uint8_t>(byte));
}

void DcsModel::take(Wire wire, std::uint8_t byte) {
  if (wire == Wire::command) {
    finish_command();
    begin(byte);
  } else if (writing_) {
    receive_pixel_byte(byte);
  } else if (command_ == nullptr || parameters_.size() == command_->most) {
    complain_of(command_ == nullptr ? "data without a command" : "more data than the command takes");
  } else {
    parameters_.push_back(byte);
    if (parameters_.size() == command_->fewest) parameters_complete();
  }
}

/// A new command ends the one before.
void DcsModel::finish_command() {
  if (!excused_) {
    if (command_ != nullptr && parameters_.size() < command_->fewest) complain_of("too few parameters");
    if (writing_ && bit_count_ != 0) complain_of("the last pixel is not whole");
  }
  excused_ = false;
  writing_ = false;
  command_ = nullptr;
  parameters_.clear();
}

void DcsModel::check_time(std::uint8_t code) {
  if (now() >= next_command_) return;
  complain(fmt::format("command {:02X}h comes {} us too early", code,
                       std::chrono::ceil<std::chrono::microseconds>(next_command_ - now()).count()));
}

/// The highest bit is sent first.
std::vector<bool> DcsModel::answer(std::uint8_t code) {
  finish_command();
  code_ = code;
  check_time(code);
  const DcsAnswer* const found = find_answer(part_, code);
  if (found == nullptr) {
    complain(fmt::format("the {} does not answer command {:02X}h", part_.name, code));
    return {};
  }
  std::vector<std::uint8_t> bytes(found->bytes.begin(), found->bytes.begin() + found->count);
  if (part_.read_index != 0 && code == 0xD3) {
    bytes = {read_index_ == 0 || read_index_ > bytes.size() ? std::uint8_t{0} : bytes[read_index_ - 1]};
  }
  read_index_ = 0;
  std::vector<bool> bits(found->dummy_clocks, false);
  for (const std::uint8_t byte : bytes) {
    for (int bit = 7; bit >= 0; --bit) bits.push_back((byte >> bit & 1) != 0);
  }
  return bits;
}

void DcsModel::begin(std::uint8_t code) {
  code_ = code;
  check_time(code);
  command_ = find_command(part_, code);
  if (command_ == nullptr) {
    complain(fmt::format("the {} has no command {:02X}h", part_.name, code));
    return;
  }
  if (command_->is_locked && keys_given_ < part_.keys.size()) complain_of("a command that is locked");
  if (command_->fewest == 0) parameters_complete();
}

void DcsModel::parameters_complete() {
  switch (code_) {
    case 0x01: reset(); break;
    case 0x10:
      if (now() < next_sleep_in_) complain("sleep-in too soon after sleep-out");
      asleep_ = true;
      next_command_ = now() + part_.sleep_to_command;
      next_sleep_out_ = now() + part_.between_sleeps;
      break;
    case 0x11:
      if (now() < next_sleep_out_) complain("sleep-out too soon after a reset or sleep-in");
      asleep_ = false;
      next_command_ = now() + part_.sleep_to_command;
      next_sleep_in_ = now() + part_.between_sleeps;
      break;
    case 0x12: partial_ = true; break;
    case 0x13: partial_ = false; break;
    case 0x20: inverted_ = false; break;
    case 0x21: inverted_ = true; break;
    case 0x28: on_ = false; break;
    case 0x29: on_ = true; break;
    case 0x2A: columns_ = range_of((access_ & kRowColumnExchange) != 0 ? part_.rows : part_.columns, "columns"); break;
    case 0x2B: rows_ = range_of((access_ & kRowColumnExchange) != 0 ? part_.columns : part_.rows, "rows"); break;
    case 0x2C:
      if (asleep_) complain("pixels before sleep-out");
      writing_ = wrote_ = true;
      full_ = false;
      column_ = columns_.first;
      row_ = rows_.first;
      bits_ = bit_count_ = 0;
      break;
    case 0x36:
      access_ = parameters_[0];
      if ((access_ & ~part_.access) != 0)
        complain(fmt::format("the {} has no memory access {:02X}h", part_.name, access_));
      break;
    case 0x3C:
      if (!wrote_) complain("pixels go on that never began");
      writing_ = true;
      bits_ = bit_count_ = 0;
      break;
    case 0x37: scroll_ = parameters_[0] * 256U + parameters_[1]; break;
    case 0x38: idle_ = false; break;
    case 0x39: idle_ = true; break;
    case 0x3A:
      format_ = parameters_[0];
      if (bits_per_pixel() == 0) complain(fmt::format("the {} has no pixel format {:02X}h", part_.name, format_));
      break;
    case 0x51: brightness_ = parameters_[0]; break;
    case 0x53: brightness_control_ = parameters_[0]; break;
    default: break;  // voltages, timing: any value shows a picture
  }
  if (part_.read_index != 0 && code_ == part_.read_index)
    read_index_ = (parameters_[0] & 0x10) != 0 ? parameters_[0] & 0x0FU : 0;
  turn_key();
}

/// Commands are unlocked as long as all keys are given. A reset takes them back.
void DcsModel::turn_key() {
  const auto fits = [this](const DcsKey& key) {
    return key.code == code_ && std::equal(parameters_.begin(), parameters_.end(), key.parameters.begin(),
                                           key.parameters.begin() + key.count);
  };
  const auto is_key = [this](const DcsKey& key) { return key.code == code_; };
  if (std::ranges::none_of(part_.keys, is_key)) return;
  if (keys_given_ == part_.keys.size() && std::ranges::any_of(part_.keys, fits)) return;
  if (keys_given_ < part_.keys.size() && fits(part_.keys[keys_given_])) {
    ++keys_given_;
  } else {
    keys_given_ = fits(part_.keys.front()) ? 1 : 0;
  }
}

DcsModel::Range DcsModel::range_of(unsigned limit, const char* what) {
  const Range range{parameters_[0] * 256U + parameters_[1], parameters_[2] * 256U + parameters_[3]};
  if (range.first > range.last || range.last >= limit) {
    complain(fmt::format("{} {} to {} of {}", what, range.first, range.last, limit));
  } else if (part_.has_even_windows && (range.first % 2 != 0 || range.last % 2 != 1)) {
    complain(
        fmt::format("{} {} to {} do not begin at an even one and end at an odd one", what, range.first, range.last));
  }
  return range;
}

/// Returns the bits of the interface format; 0 if there is no such format.
unsigned DcsModel::bits_per_pixel() const {
  switch (format_ & 7U) {
    case 3: return part_.has_12_bits ? 12 : 0;
    case 5: return part_.has_16_bits ? 16 : 0;
    case 6: return 24;  // 18 of them are used
    default: return 0;
  }
}

void DcsModel::receive_pixel_byte(std::uint8_t byte) {
  const unsigned bits = bits_per_pixel();
  if (bits == 0) return;
  bits_ = bits_ << 8 | byte;
  bit_count_ += 8;
  while (bit_count_ >= bits) {
    bit_count_ -= bits;
    const std::uint32_t pixel = bits_ >> bit_count_;
    if (bits == 12) {
      store({six_bits(pixel >> 8 & 15, 4), six_bits(pixel >> 4 & 15, 4), six_bits(pixel & 15, 4)});
    } else if (bits == 16) {
      store({six_bits(pixel >> 11 & 31, 5), static_cast<std::uint8_t>(pixel >> 5 & 63), six_bits(pixel & 31, 5)});
    } else {
      store({static_cast<std::uint8_t>(pixel >> 18 & 63), static_cast<std::uint8_t>(pixel >> 10 & 63),
             static_cast<std::uint8_t>(pixel >> 2 & 63)});
    }
  }
}

void DcsModel::store(const Colour& colour) {
  if (full_) complain_of("more pixels than the window has");
  const bool exchange = (access_ & kRowColumnExchange) != 0;
  unsigned column = exchange ? row_ : column_;
  unsigned row = exchange ? column_ : row_;
  if (column < part_.columns && row < part_.rows) {
    if ((access_ & kColumnOrder) != 0) column = part_.columns - 1U - column;
    if ((access_ & kRowOrder) != 0) row = part_.rows - 1U - row;
    memory_[cell(column, row)] = colour;
  } else {
    complain_of("a pixel outside of the memory");
  }
  if (column_++ != columns_.last) return;
  column_ = columns_.first;
  if (row_++ != rows_.last) return;
  row_ = rows_.first;
  full_ = true;
}

std::size_t DcsModel::cell(unsigned column, unsigned row) const { return std::size_t{row} * part_.columns + column; }

std::string DcsModel::darkness() const {
  if (asleep_) return "the panel is asleep";
  if (!on_) return "the display is off";
  if (part_.is_lit_by_brightness && brightness() == 0U) return "the brightness is 0";
  return {};
}

/// WRDISBV has effect while WRCTRLD has its block (BCTRL) and, where there is one, the backlight (BL) on.
std::optional<unsigned> DcsModel::brightness() const {
  if (find_command(part_, 0x51) == nullptr) return std::nullopt;
  return (brightness_control_ & part_.brightness_bits) == part_.brightness_bits ? brightness_ : 0U;
}

/// The pixel's centre lies in the largest circle of the glass. Counted in half pixels from the glass's centre.
bool DcsModel::is_on_disc(unsigned x, unsigned y) const {
  const auto from_centre = [](unsigned at, unsigned size) {
    return 2 * static_cast<int>(at) + 1 - static_cast<int>(size);
  };
  const int across = from_centre(x, glass_.width), down = from_centre(y, glass_.height);
  const int diameter = std::min(glass_.width, glass_.height);
  return across * across + down * down <= diameter * diameter;
}

RgbImage DcsModel::seen() const {
  RgbImage image{glass_.width, glass_.height, {}};
  image.rgb.assign(std::size_t{glass_.width} * glass_.height * 3, 0);
  if (!darkness().empty()) return image;
  std::uint8_t* out = image.rgb.data();
  for (unsigned y = 0; y < glass_.height; ++y) {
    for (unsigned x = 0; x < glass_.width; ++x, out += 3) {
      if (glass_.is_round && !is_on_disc(x, y)) continue;
      const unsigned column_from_edge = glass_.column_offset + x;
      const unsigned row_from_edge = glass_.row_offset + y;
      const unsigned column = glass_.columns_reversed ? part_.columns - 1U - column_from_edge : column_from_edge;
      const unsigned row = glass_.rows_reversed ? part_.rows - 1U - row_from_edge : row_from_edge;
      const Colour& colour = memory_[cell(column, (row + scroll_) % part_.rows)];
      const bool swapped = glass_.bgr != ((access_ & kBgrOrder) != 0);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        unsigned value = colour[swapped ? 2 - channel : channel];
        if (inverted_ != glass_.inverted) value = 63 - value;
        if (idle_) value = value >= 32 ? 63 : 0;  // eight colours
        out[channel] = static_cast<std::uint8_t>(value << 2 | value >> 4);
      }
    }
  }
  return image;
}

}  // namespace zstrip::sim
